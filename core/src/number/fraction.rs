//! Where a point stands between the edge of a cone and its middle, and what edge profiles make of it; also the cosine of
//! an angle of incidence.
//!
//! A profile magnifies the rounding of its argument by its slope, so a fraction has one bit more than a scalar; it
//! costs nothing, because the products that use it are as wide as before.

#[cfg(feature = "fixed")]
mod fixed_point;

#[cfg(feature = "fixed")]
pub(super) use fixed_point::{Fraction16, Fraction32};

use super::{Arithmetic, Knot, RealExponent, Share, float, knot::SLOPE_BITS};

/// A number from 0 to 1, one bit finer than the scalar: the argument of an edge profile.
///
/// Made by [`Arithmetic::rise`] and [`Ray::cosine`](super::Ray::cosine) alone, so that it is in its range whatever the
/// input was. In what follows it is called `t`, and `u = 1 - t`.
pub trait Fraction<S: Arithmetic>: Copy + PartialOrd + core::fmt::Debug {
    /// What a profile makes of it: a scalar, or a number of more bits where the scalar's are too few.
    type Value: Share<S>;

    /// `1 - t`.
    fn complement(self) -> Self;
    /// The product, kept fine: to be multiplied again.
    fn fine_product(self, other: Self) -> Self;
    /// The product, rounded once.
    fn product(self, other: Self) -> Self::Value;
    /// `t^p` for a real exponent, kept fine: exactly 0 at 0 and 1 at 1, within `2e-9 + 6.5e-10 p` of the power of `t` before
    /// the format rounds it. Eleven multiplies of 64 bits in every format. Of an exponent with a floor,
    /// `(max(t, floor)^p - floor^p) / (1 - floor^p)`.
    fn real_power(self, exponent: RealExponent) -> Self;
    /// The nearest value.
    fn scalar(self) -> Self::Value;
    /// The product with a value from 0 to 1.
    fn of(self, value: Self::Value) -> Self::Value;
    /// `1 - value`.
    #[inline]
    fn lack(value: Self::Value) -> Self::Value {
        value.rest()
    }
    /// `low - (low - high) share`: from `low` to a `high` that is not over it; in [0, 1] whatever the share is.
    fn mixed(low: Self::Value, high: Self::Value, share: S) -> Self::Value;
    /// One wherever `t` is more than zero.
    fn step(self) -> Self::Value;
    /// `t^2 (3 - 2 t)`: two multiplies.
    fn smooth(self) -> Self::Value;
    /// `t (1 + g u)` for `g` in [-1, 1]: two multiplies.
    fn quadratic(self, g: S::Weight) -> Self::Value;
    /// `t (1 + u (g + h t))` for `g` in [-1, 3], `h` in [-4, 2] and `g + h` in [-3, 1], where it is monotone: three
    /// multiplies.
    fn cubic(self, g: S::Weight, h: S::Weight) -> Self::Value;
    /// The linear interpolation of samples that are evenly spaced from `u = 0`, 65,535 being one: one multiply, and
    /// one to find the place. No samples are dark; at most 65,536 are looked at.
    fn sample(self, samples: &[u16]) -> Self::Value;
    /// The value of a polyline over `u`, clamped to [0, 1]: a binary search and one multiply. No knots are dark.
    fn along(self, knots: &[Knot]) -> Self::Value;
}

/// A fraction in f32.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub struct FloatFraction(pub(super) f32);

impl Fraction<f32> for FloatFraction {
    type Value = f32;

    #[inline]
    fn mixed(low: f32, high: f32, share: f32) -> f32 {
        float::clamp(low - (low - high) * share)
    }

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

    #[inline(always)] // `table.f32` on Cortex-M0: +69 without.
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

/// Two neighbouring samples; beyond the last one it is its own neighbour.
#[inline]
pub(super) fn neighbours(samples: &[u16], index: usize) -> (u16, u16) {
    let here = samples.get(index).copied().unwrap_or(0);
    (here, samples.get(index + 1).copied().unwrap_or(here))
}
