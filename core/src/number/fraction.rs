//! Fractions: arguments of falloffs, with the falloffs' formulas, and cosines of angles of
//! incidence.
//!
//! A falloff multiplies the rounding error of its argument by the falloff's derivative, so in fixed
//! point a fraction has one bit more than a scalar. The extra bit costs nothing, because a product
//! of fractions needs no wider integer than a product of scalars.

use super::{Arithmetic, Knot, RealExponent, Share, float, knot::SLOPE_BITS};

/// A number in `[0, 1]`, the argument of a falloff. In fixed point a fraction has more bits than a
/// scalar.
///
/// Only [`Arithmetic::rise`], [`Ray::rise`](super::Ray::rise) and
/// [`Ray::cosine`](super::Ray::cosine) create fractions, so the argument of a falloff is in range
/// for every input. In the descriptions of the functions, this fraction is `t`, and `u = 1 - t`.
pub trait Fraction<S: Arithmetic>: Copy + PartialOrd + core::fmt::Debug {
    /// Result type of a falloff: a scalar, or a number with more bits if a scalar has too few.
    type Value: Share<S>;

    /// Returns `1 - t`.
    fn complement(self) -> Self;
    /// Returns the product of two fractions as a fraction, for further multiplication.
    fn fine_product(self, other: Self) -> Self;
    /// Returns the product of two fractions, rounded once to a value.
    fn product(self, other: Self) -> Self::Value;
    /// Returns `t^p` for a non-integer exponent `p` as a fraction: exactly 0 at `t = 0` and exactly 1 at
    /// `t = 1`.
    ///
    /// The error before the format's own rounding is at most `2e-9 + 6.5e-10 p`. The function takes
    /// eleven 64-bit multiplications in every format. For an exponent with a floor the function
    /// returns `(max(t, floor)^p - floor^p) / (1 - floor^p)`.
    fn real_power(self, exponent: RealExponent) -> Self;
    /// Returns `t`, rounded to the nearest value.
    fn scalar(self) -> Self::Value;
    /// Returns `t` times a value in `[0, 1]`.
    fn of(self, value: Self::Value) -> Self::Value;
    /// Returns `1 - value`.
    #[inline]
    fn lack(value: Self::Value) -> Self::Value {
        value.rest()
    }
    /// Returns 1 if `t > 0`, else 0.
    fn step(self) -> Self::Value;
    /// Returns `t^2 (3 - 2 t)`: two multiplications.
    fn smooth(self) -> Self::Value;
    /// Returns `t (1 + g u)` for `g` in `[-1, 1]`: two multiplications.
    fn quadratic(self, g: S::Weight) -> Self::Value;
    /// Returns `t (1 + u (g + h t))`: three multiplications.
    ///
    /// Valid coefficients are `g` in `[-1, 3]`, `h` in `[-4, 2]` and `g + h` in `[-3, 1]`, where
    /// the cubic is monotone.
    fn cubic(self, g: S::Weight, h: S::Weight) -> Self::Value;
    /// Interpolates linearly between samples that are evenly spaced from `u = 0`; 65,535 means 1.
    ///
    /// The function takes one multiplication for the position and one for the interpolation.
    /// Without samples the result is 0; at most 65,536 samples are supported.
    fn sample(self, samples: &[u16]) -> Self::Value;
    /// Returns the value at `u` of the line that starts at the last knot before `u`, clamped to
    /// `[0, 1]`.
    ///
    /// The function takes a binary search and one multiplication. Without knots the result is 0.
    fn along(self, knots: &[Knot]) -> Self::Value;
}

/// A fraction in f32.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub struct FloatFraction(pub(super) f32);

impl Fraction<f32> for FloatFraction {
    type Value = f32;

    #[inline]
    fn complement(self) -> Self {
        Self(1.0 - self.0)
    }

    #[inline]
    fn fine_product(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }

    #[inline]
    fn product(self, other: Self) -> f32 {
        self.0 * other.0
    }

    #[inline]
    fn scalar(self) -> f32 {
        self.0
    }

    fn real_power(self, exponent: RealExponent) -> Self {
        Self(exponent.of_f32(self.0) as f32 * (1.0 / 2_147_483_648.0))
    }

    #[inline]
    fn of(self, scalar: f32) -> f32 {
        scalar * self.0
    }

    #[inline]
    fn step(self) -> f32 {
        if self.0 > 0.0 { 1.0 } else { 0.0 }
    }

    #[inline]
    fn smooth(self) -> f32 {
        float::clamp(self.0 * self.0 * (3.0 - (self.0 + self.0)))
    }

    #[inline]
    fn quadratic(self, g: f32) -> f32 {
        float::clamp(self.0 * (1.0 + (1.0 - self.0) * g))
    }

    #[inline]
    fn cubic(self, g: f32, h: f32) -> f32 {
        float::clamp(self.0 * (1.0 + (1.0 - self.0) * (g + h * self.0)))
    }

    #[inline(always)] // `table.f32` on Cortex-M0: +69 instructions without.
    fn sample(self, samples: &[u16]) -> f32 {
        let place = (1.0 - self.0) * samples.len().saturating_sub(1) as f32;
        let index = place as usize;
        let (here, next) = neighbours(samples, index);
        let (here, next) = (f32::from(here), f32::from(next));
        float::clamp((here + (next - here) * (place - index as f32)) * (1.0 / 65_535.0))
    }

    #[inline]
    fn along(self, knots: &[Knot]) -> f32 {
        const STEP: f32 = 1.0 / (1 << SLOPE_BITS) as f32;
        let place = (1.0 - self.0) * 65_536.0;
        let knot = Knot::at(knots, place as u32);
        let rise = (place - f32::from(knot.place)) * (knot.slope as f32 * STEP);
        float::clamp((f32::from(knot.value) + rise) * (1.0 / 65_535.0))
    }
}

/// Returns a sample and its successor; the last sample is its own successor.
#[inline]
pub(super) fn neighbours(samples: &[u16], index: usize) -> (u16, u16) {
    let here = samples.get(index).copied().unwrap_or(0);
    (here, samples.get(index + 1).copied().unwrap_or(here))
}
