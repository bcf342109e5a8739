//! Integer powers with a run-time exponent, by repeated squaring.

use super::{CompiledFalloff, Falloff, Formula};
use crate::{
    error::{Error, Parameter},
    model::{Model as _, Number, model},
    number::{Fraction, Scalar, Share},
    trig,
};

model! {
    /// The power `t^n` with an exponent chosen at run time. The evaluation loops over the binary digits
    /// of `n`; for [`Power`](crate::falloff::Power) the compiler unrolls this loop. The results of both
    /// types are bit-identical.
    #[derive(Eq)]
    IntegerPower {
        /// Returns the exponent.
        exponent: u32 = Number::whole(Parameter::Exponent, 1, MOST, 15);
    } by Self::new(exponent)
}

model! {
    /// The inverted power `1 - u^n` with an exponent chosen at run time. Results are bit-identical to
    /// [`InvertedPower`](crate::falloff::InvertedPower).
    #[derive(Eq)]
    InvertedIntegerPower {
        /// Returns the exponent.
        exponent: u32 = Number::whole(Parameter::Exponent, 1, MOST, 4);
    } by Self::new(exponent)
}

/// The largest exponent, 8 times the largest exponent of OpenGL. A field angle of 15 degrees needs
/// an exponent of 268 (Hast 2004, figure 7).
pub(crate) const MOST: u32 = 1_024;

/// Returns `1 - exp(-x)` for `x` in [0, 2.4], accurate to the last place.
///
/// The function sums the series of the exponential without its first term, 1, to avoid
/// cancellation.
pub(super) fn lost_after(x: f32) -> f32 {
    let terms = (2..=20).rev().fold(1.0, |sum, n| 1.0 - x / n as f32 * sum);
    x * terms
}

/// Returns `x^n` by repeated squaring, for set-up only. The function computes in f64, because the
/// power magnifies the relative rounding error of `x` by `n`.
pub(super) fn raised(x: f64, n: u32) -> f64 {
    let (mut power, mut square, mut rest) = (1.0, x, n);
    while rest > 0 {
        if rest % 2 == 1 {
            power *= square;
        }
        square *= square;
        rest /= 2;
    }
    power
}

/// Returns `t^n` for `n >= 1`, in the extended precision of the fraction `F`.
///
/// The function squares once per binary digit of `n`, from the second highest digit down. `n = 0`
/// returns `t`.
#[inline]
pub(super) fn power<S: Scalar, F: Fraction<S>>(t: F, n: u32) -> F {
    let mut power = t;
    // `n` is never 0 here. `n | 1` makes the compiler remove the panic of `ilog2` for 0.
    let mut digit = (n | 1).ilog2();
    while digit > 0 {
        digit -= 1;
        power = power.times(power);
        if n >> digit & 1 == 1 {
            power = power.times(t);
        }
    }
    power
}

/// Returns `t^n`, whose last product is rounded directly to the result type.
#[inline]
pub(super) fn rounded_power<S: Scalar, F: Fraction<S>>(t: F, n: u32) -> F::Value {
    if n == 1 {
        t.value()
    } else if n % 2 == 0 {
        let root = power(t, n / 2);
        root.times_to_value(root)
    } else {
        power(t, n - 1).times_to_value(t)
    }
}

impl IntegerPower {
    /// Creates the power with this exponent.
    ///
    /// # Errors
    /// An exponent outside 1 to 1,024.
    pub fn new(exponent: u32) -> Result<Self, Error> {
        Ok(Self { exponent: Self::NUMBERS[0].checked_whole(exponent)? })
    }

    /// Creates the power with an exponent that is already validated.
    pub(crate) const fn of(exponent: u32) -> Self {
        Self { exponent }
    }
}

impl InvertedIntegerPower {
    /// Creates the inverted power with this exponent.
    ///
    /// # Errors
    /// An exponent outside 1 to 1,024.
    pub fn new(exponent: u32) -> Result<Self, Error> {
        Ok(Self { exponent: Self::NUMBERS[0].checked_whole(exponent)? })
    }

    /// Creates the inverted power with an exponent that is already validated.
    pub(crate) const fn of(exponent: u32) -> Self {
        Self { exponent }
    }
}

impl Falloff for IntegerPower {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        Formula::Power(self.exponent as f32)
    }

    /// Returns `1 - (1/2)^(1/n)`.
    fn beam_versine(self) -> f32 {
        lost_after(core::f32::consts::LN_2 / self.exponent as f32)
    }

    /// Returns `1 - (1/10)^(1/n)`.
    fn field_versine(self) -> f32 {
        lost_after(core::f32::consts::LN_10 / self.exponent as f32)
    }

    /// Returns the maximum of `2 n (1 - v)^(n - 1) sqrt(v)` over the versine `v`.
    ///
    /// The maximum is at `v = 1 / (2 n - 1)`, or at the inner angle if the inner angle is farther
    /// out.
    fn steepness(self, hotspot: f32) -> f32 {
        let (n, hotspot) = (self.exponent, f64::from(hotspot));
        let span = 1.0 - hotspot;
        let steepest = (1.0 / f64::from(2 * n - 1)).max(hotspot);
        let slope = 2.0 * f64::from(n) * raised((1.0 - steepest) / span, n - 1) / span;
        slope as f32 * trig::sqrt(steepest as f32)
    }

    fn integral(self, u: f32) -> f32 {
        // (1 - t^(n + 1)) / (1 - t) as a sum of powers: no cancellation for small u.
        let (n, t) = (self.exponent, 1.0 - f64::from(u));
        let (sum, _) = (0..=n).fold((0.0, 1.0), |(sum, power), _| (sum + power, power * t));
        u * (sum / f64::from(n + 1)) as f32
    }
}

impl<S: Scalar> CompiledFalloff<S> for IntegerPower {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        rounded_power::<S, F>(t, self.exponent)
    }
}

impl Falloff for InvertedIntegerPower {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        Formula::InvertedPower(self.exponent as f32, 0.0)
    }

    /// Returns `(1/2)^(1/n)`.
    fn beam_versine(self) -> f32 {
        1.0 - lost_after(core::f32::consts::LN_2 / self.exponent as f32)
    }

    /// Returns `(9/10)^(1/n)`.
    fn field_versine(self) -> f32 {
        const LOST: f32 = 0.105_360_516; // ln(10/9)
        1.0 - lost_after(LOST / self.exponent as f32)
    }

    /// Returns the derivative at the edge: `2 n` without a hotspot.
    fn steepness(self, hotspot: f32) -> f32 {
        2.0 * self.exponent as f32 / (1.0 - hotspot)
    }

    fn integral(self, u: f32) -> f32 {
        let lost = raised(u.into(), self.exponent + 1) / f64::from(self.exponent + 1);
        u - lost as f32
    }
}

impl<S: Scalar> CompiledFalloff<S> for InvertedIntegerPower {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        rounded_power::<S, F>(t.complement(), self.exponent).complement()
    }
}
