//! Integer powers whose exponent is known at run time, by repeated squaring.

use super::{Curve, Profile, without_coefficients};
use crate::{
    error::{Accepted, Error, Parameter},
    scalar::{Fraction, Scalar},
    trig,
};

/// The power `t^n` of an exponent that is known at run time: a loop over its binary digits where
/// [`Power`](crate::Power) is unrolled by the compiler, with the same bits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct IntegerPower {
    exponent: u32,
}

/// The rim power `1 - u^n` of an exponent that is known at run time, with the bits of [`Rim`](crate::Rim).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct IntegerRim {
    exponent: u32,
}

/// The largest exponent: that of OpenGL.
pub(crate) const MOST: u32 = 128;

/// An exponent in a closed range, or the error that names it.
pub(super) fn checked(exponent: u32, least: u32, most: u32) -> Result<u32, Error> {
    if (least..=most).contains(&exponent) {
        Ok(exponent)
    } else {
        let accepted = Accepted::WholeBetween(least, most);
        Err(Error { parameter: Parameter::Exponent, value: exponent as f32, accepted })
    }
}

/// `1 - exp(-x)` for `x` in [0, 2.4], without cancellation: the series of the exponential, to the last place.
fn lost_after(x: f32) -> f32 {
    let terms = (2..=20).rev().fold(1.0, |sum, n| 1.0 - x / n as f32 * sum);
    x * terms
}

/// `x^n`, set-up only.
fn raised(x: f32, n: u32) -> f32 {
    (0..n).fold(1.0, |product, _| product * x)
}

/// `t^n` for `n` from 1 up, kept fine: by the binary digits of `n`, from the second highest down. `t` for 0.
#[inline(always)]
pub(super) fn power<S: Scalar>(t: S::Fraction, n: u32) -> S::Fraction {
    let mut power = t;
    // No exponent is 0, but only so does the compiler know: the logarithm of 0 would panic.
    let mut digit = (n | 1).ilog2();
    while digit > 0 {
        digit -= 1;
        power = power.fine_product(power);
        if n >> digit & 1 == 1 {
            power = power.fine_product(t);
        }
    }
    power
}

/// `t^n`, whose last product is rounded to the scalar at once.
#[inline(always)]
pub(super) fn rounded_power<S: Scalar>(t: S::Fraction, n: u32) -> S {
    if n == 1 {
        t.scalar()
    } else if n.is_multiple_of(2) {
        let root = power::<S>(t, n / 2);
        root.product(root)
    } else {
        power::<S>(t, n - 1).product(t)
    }
}

impl IntegerPower {
    /// The power of this exponent.
    ///
    /// # Errors
    /// An exponent outside 1 to 128.
    pub fn new(exponent: u32) -> Result<Self, Error> {
        Ok(Self { exponent: checked(exponent, 1, MOST)? })
    }

    /// The power of an exponent that is known to be sound.
    pub(crate) const fn of(exponent: u32) -> Self {
        Self { exponent }
    }

    /// The exponent.
    pub fn exponent(self) -> u32 {
        self.exponent
    }
}

impl IntegerRim {
    /// The rim power of this exponent.
    ///
    /// # Errors
    /// An exponent outside 1 to 128.
    pub fn new(exponent: u32) -> Result<Self, Error> {
        Ok(Self { exponent: checked(exponent, 1, MOST)? })
    }

    /// The rim power of an exponent that is known to be sound.
    pub(crate) const fn of(exponent: u32) -> Self {
        Self { exponent }
    }

    /// The exponent.
    pub fn exponent(self) -> u32 {
        self.exponent
    }
}

impl Profile for IntegerPower {
    without_coefficients!();

    /// `1 - (1/2)^(1/n)`.
    fn beam_versine(self) -> f32 {
        lost_after(core::f32::consts::LN_2 / self.exponent as f32)
    }

    /// `1 - (1/10)^(1/n)`.
    fn field_versine(self) -> f32 {
        lost_after(core::f32::consts::LN_10 / self.exponent as f32)
    }

    /// The largest of `2 n (1 - v)^(n - 1) sqrt(v)`, at `v = 1 / (2 n - 1)` if that is outside the hotspot.
    fn steepness(self, hotspot: f32) -> f32 {
        let (n, span) = (self.exponent, 1.0 - hotspot);
        let steepest = (1.0 / (2 * n - 1) as f32).max(hotspot);
        2.0 * n as f32 * raised((1.0 - steepest) / span, n - 1) * trig::sqrt(steepest) / span
    }

    fn integral(self, u: f32) -> f32 {
        // (1 - t^(n + 1)) / (1 - t) is a sum of powers: nothing cancels where u is small.
        let n = self.exponent;
        let (sum, _) = (0..=n).fold((0.0, 1.0), |(sum, power), _| (sum + power, power * (1.0 - u)));
        u * sum / (n + 1) as f32
    }
}

impl<S: Scalar> Curve<S> for IntegerPower {
    #[inline(always)]
    fn intensity(self, t: S::Fraction) -> S {
        rounded_power::<S>(t, self.exponent)
    }
}

impl Profile for IntegerRim {
    without_coefficients!();

    /// `(1/2)^(1/n)`.
    fn beam_versine(self) -> f32 {
        1.0 - lost_after(core::f32::consts::LN_2 / self.exponent as f32)
    }

    /// `(9/10)^(1/n)`.
    fn field_versine(self) -> f32 {
        const LOST: f32 = 0.105_360_516; // ln(10/9)
        1.0 - lost_after(LOST / self.exponent as f32)
    }

    /// The slope at the edge: `2 n` without a hotspot.
    fn steepness(self, hotspot: f32) -> f32 {
        2.0 * self.exponent as f32 / (1.0 - hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        u - raised(u, self.exponent + 1) / (self.exponent + 1) as f32
    }
}

impl<S: Scalar> Curve<S> for IntegerRim {
    #[inline(always)]
    fn intensity(self, t: S::Fraction) -> S {
        S::ONE.minus(rounded_power::<S>(t.complement(), self.exponent))
    }
}
