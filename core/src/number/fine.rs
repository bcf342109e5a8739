//! Fractions with 31 fraction bits, computed with 32-bit products.
//!
//! Two evaluations use these fractions: the fine evaluation of [`Fx16`], for cones and lights that
//! need more than 15 fraction bits, and the evaluation of [`Fx32`], because 32-bit products need
//! fewer instructions than 64-bit products.

use super::{
    Arithmetic, Fraction, Fx16, Fx32, Gain16, Gain32, Knot, Light16, Light32, RealExponent, Share, Weight16,
    Weight32, cold_path,
    fraction::neighbours,
    product::{high_half, high_product},
};

/// A number in `[0, 1]` with 31 fraction bits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Default, Debug)]
pub struct Fine(pub(in crate::number) u32);

impl Fine {
    pub(in crate::number) const ONE: Self = Self(1 << 31);

    /// Returns `1 - self`.
    #[inline]
    fn lacking(self) -> Self {
        Self(Self::ONE.0 - self.0)
    }

    /// Returns the product, at most 2^-30 below the exact product; exactly 1 if both factors are 1.
    #[inline]
    fn times(self, other: Self) -> Self {
        Self(high_half(self.0, other.0) << 1)
    }

    /// Returns the fraction with the bits `product / 2^shift`, capped at 1.
    #[inline]
    pub(in crate::number) fn capped(product: u32, shift: i32) -> Self {
        let capped = if shift >= 0 {
            product.checked_shr(shift.unsigned_abs()).unwrap_or(0)
        } else if shift.unsigned_abs() < product.leading_zeros() {
            product << shift.unsigned_abs()
        } else if product > 0 {
            Self::ONE.0
        } else {
            0
        };
        Self(capped.min(Self::ONE.0))
    }

    /// Converts a table sample, shifted left by 15 bits, to a fraction. The sample 65,535 means 1.
    ///
    /// The conversion multiplies by the first two terms of `2^16 / (2^16 - 1) = 1 + 2^-16 + ..`
    #[inline]
    fn of_value(value: u32) -> Self {
        Self((value + ((value + (1 << 15)) >> 16)).min(Self::ONE.0))
    }

    /// Returns `t^2 (3 - 2t)` for this fraction `t`.
    #[inline(always)] // `spot-smooth-lambert` on Cortex-M0: +5 instructions without.
    fn eased(self) -> Self {
        let square = self.times(self);
        Self((square.0 + 2 * square.times(self.lacking()).0).min(Self::ONE.0))
    }

    /// Returns `t (1 + u slope)` for this fraction `t`, `u = 1 - t` and a slope with 28 fraction
    /// bits. The result is clamped to `[0, 1]`, also for an invalid slope.
    #[inline]
    fn lifted(self, slope: i32) -> Self {
        // A valid slope is in `[-3, 3]`, so `t u slope` with 27 fraction bits fits 28 bits.
        let lift = high_half(self.times(self.lacking()).0, slope.unsigned_abs());
        let lift = lift.min((1 << 28) - 1) << 4;
        let lifted = if slope < 0 { self.0.saturating_sub(lift) } else { self.0.saturating_add(lift) };
        Self(lifted.min(Self::ONE.0))
    }
}

/// A coefficient of a falloff that converts to a slope with 28 fraction bits.
pub trait Slope: Copy {
    /// Returns the slope. The conversion wraps for a coefficient that is out of range.
    fn slope(self) -> i32;
}

impl Slope for Weight16 {
    #[inline]
    fn slope(self) -> i32 {
        self.to_bits().wrapping_shl(28 - Self::FRACTION_BITS)
    }
}

impl Slope for Weight32 {
    #[inline]
    fn slope(self) -> i32 {
        (self.to_bits() >> (Self::FRACTION_BITS - 28)) as i32
    }
}

impl<S: Arithmetic<Weight: Slope>> Fraction<S> for Fine
where
    Self: Share<S>,
{
    type Value = Self;

    #[inline]
    fn complement(self) -> Self {
        self.lacking()
    }

    #[inline]
    fn fine_product(self, other: Self) -> Self {
        self.times(other)
    }

    #[inline]
    fn product(self, other: Self) -> Self {
        self.times(other)
    }

    #[inline]
    fn real_power(self, exponent: RealExponent) -> Self {
        Self(exponent.of_bits(self.0) as u32)
    }

    #[inline]
    fn scalar(self) -> Self {
        self
    }

    #[inline(always)] // `spot-step-lambert` on Cortex-M0: +38 instructions without.
    fn of(self, value: Self) -> Self {
        self.times(value)
    }

    #[inline]
    fn step(self) -> Self {
        if self.0 > 0 { Self::ONE } else { Self(0) }
    }

    #[inline(always)] // `spot-smooth-lambert` on Cortex-M0: +5 instructions without.
    fn smooth(self) -> Self {
        self.eased()
    }

    #[inline]
    fn quadratic(self, g: S::Weight) -> Self {
        self.lifted(g.slope())
    }

    #[inline]
    fn cubic(self, g: S::Weight, h: S::Weight) -> Self {
        let bend = (high_half(self.0, h.slope().unsigned_abs()) as i32) << 1;
        let bend = if h.slope() < 0 { bend.wrapping_neg() } else { bend };
        self.lifted(g.slope().wrapping_add(bend))
    }

    #[inline]
    fn sample(self, samples: &[u16]) -> Self {
        let last = (samples.len().min(1 << 16) as u32).saturating_sub(1);
        let place = self.lacking().0;
        // The position among the samples is the product of `place` and `last`, with 31 fraction
        // bits.
        let (here, next) = neighbours(samples, (high_product(place, last) >> 15) as usize);
        let share = place.wrapping_mul(last) & (Self::ONE.0 - 1);
        let (value, step) = (u32::from(here) << 15, high_product(share, here.abs_diff(next).into()));
        Self::of_value(if next < here { value - step } else { value + step })
    }

    #[inline]
    fn along(self, knots: &[Knot]) -> Self {
        let place = self.lacking().0;
        let knot = Knot::at(knots, place >> 15);
        let (beyond, slope) = (place - (u32::from(knot.place) << 15).min(place), knot.slope.unsigned_abs());
        // The product of `beyond` and `slope` has at most 46 bits for a valid line; its lower 15
        // bits are dropped.
        let rise = high_half(beyond, slope) << 17 | beyond.wrapping_mul(slope) >> 15;
        let value = u32::from(knot.value) << 15;
        let value = if knot.slope < 0 { value.saturating_sub(rise) } else { value.saturating_add(rise) };
        Self::of_value(value.min(65_535 << 15))
    }
}

/// Defines the functions of `Share` that are the same for `Fx16` and `Fx32`.
macro_rules! share_operations {
    () => {
        #[inline]
        fn is_all(self) -> bool {
            self == Self::ONE
        }

        #[inline]
        fn rest(self) -> Self {
            self.lacking()
        }

        #[inline(always)] // `spot-soft-lambert-smooth-range` on Cortex-M0: +22 instructions without.
        fn share_of(self, other: Self) -> Self {
            self.times(other)
        }

        #[inline]
        fn smoothed(self) -> Self {
            self.eased()
        }
    };
}

impl Share<Fx16> for Fine {
    #[inline]
    fn of_scalar(scalar: Fx16) -> Self {
        Self(u32::from(scalar.to_bits().clamp(0, 1 << 14) as u16) << 17)
    }

    #[inline]
    fn rounded(self) -> Fx16 {
        Fx16::from_bits(((self.0 + (1 << 16)) >> 17) as i16)
    }

    share_operations!();

    #[inline(always)] // `spot-soft-lambert-hotspot` on Cortex-M0: +28 instructions without.
    fn give(self, gain: Gain16) -> Light16 {
        Light16::shifted(high_half(self.0, gain.mantissa), gain.shift - 15)
    }
}

impl Share<Fx32> for Fine {
    #[inline]
    fn of_scalar(scalar: Fx32) -> Self {
        Self((scalar.to_bits().clamp(0, 1 << 30) as u32) << 1)
    }

    #[inline]
    fn rounded(self) -> Fx32 {
        Fx32::from_bits(self.0.div_ceil(2) as i32)
    }

    share_operations!();

    #[inline]
    fn give(self, gain: Gain32) -> Light32 {
        light(high_half(self.0, gain.mantissa << 4), gain.shift - 27)
    }
}

/// Returns the light with the bits `product / 2^shift`, rounded to nearest; saturates.
///
/// The result is that of [`Light32::shifted`], computed with shifts of 32-bit numbers.
#[inline]
pub(in crate::number) fn light(product: u32, shift: i32) -> Light32 {
    let (but_one, up) = (shift.wrapping_sub(1) as u32, shift.wrapping_neg() as u32);
    if but_one < u32::BITS {
        let doubled = product >> but_one;
        Light32::from_bits(((doubled >> 1) + (doubled & 1)).into())
    } else if up < u32::BITS {
        let high = (product >> 1) >> (u32::BITS - 1 - up);
        Light32::from_bits(u64::from(high) << u32::BITS | u64::from(product << up))
    } else {
        cold_path();
        Light32::shifted(product.into(), shift)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every sample converts to the nearest fraction, and 65,535 converts to exactly 1.
    #[test]
    fn the_share_of_a_sample_is_the_nearest() {
        for value in 0..=65_535_u32 {
            let exact = f64::from(value) / 65_535.0 * 2_147_483_648.0;
            let found = Fine::of_value(value << 15);
            assert!(
                (f64::from(found.0) - exact).abs() <= 0.5,
                "sample {value}: {found:?}, expected the nearest to {exact}"
            );
        }
        assert_eq!(Fine::of_value(65_535 << 15), Fine::ONE);
    }

    /// Tests a table with the largest number of samples, which fall evenly.
    #[test]
    fn the_longest_table_is_sampled_to_its_end() {
        static SAMPLES: [u16; 65_536] = {
            let mut samples = [0; 65_536];
            let mut i = 0;
            while i < 65_536 {
                samples[i] = 65_535 - i as u16;
                i += 1;
            }
            samples
        };
        for t in [0, 1 << 15, 1 << 29, 1 << 30, 3 << 29, (1 << 31) - 1, 1 << 31] {
            let found = Fraction::<Fx16>::sample(Fine(t), &SAMPLES);
            assert!(found.0.abs_diff(t) <= 1 << 16, "{found:?}, expected {t} within 2^16");
        }
    }

    /// A product of distance and slope has up to 46 bits, of which the lower 15 are dropped.
    #[test]
    fn a_line_keeps_all_its_bits() {
        for slope in [-32_768, -12_345, -1, 1, 7_777, 32_767] {
            let knot = Knot::from_bits(0, if slope < 0 { 65_535 } else { 0 }, slope);
            for t in (0..1 << 31).step_by(10_000_019) {
                let beyond = f64::from((1_u32 << 31) - t) / 32_768.0;
                let line = f64::from(knot.value) + f64::from(slope) * beyond / 32_768.0;
                let exact = line.clamp(0.0, 65_535.0) / 65_535.0 * 2_147_483_648.0;
                let found = Fraction::<Fx16>::along(Fine(t), &[knot]);
                assert!((f64::from(found.0) - exact).abs() <= 2.0, "{slope} {t}: {found:?} for {exact}");
            }
        }
    }

    #[test]
    fn light_is_shifted_as_in_64_bits() {
        for product in [0, 1, 2, 3, 0x8000_0001, 0x9e37_79b9, u32::MAX] {
            for shift in (-70..70).chain([i32::MIN, i32::MAX]) {
                assert_eq!(
                    light(product, shift),
                    Light32::shifted(product.into(), shift),
                    "{product} {shift}"
                );
            }
        }
    }

    #[test]
    fn a_scalar_outside_of_0_to_1_is_the_nearest_share() {
        let share = |bits| <Fine as Share<Fx16>>::of_scalar(Fx16::from_bits(bits));
        assert_eq!([i16::MIN, -1, 0].map(share), [Fine(0); 3]);
        assert_eq!([1 << 14, (1 << 14) + 1, i16::MAX].map(share), [Fine::ONE; 3]);
        assert_eq!(share(1), Fine(1 << 17));
    }
}
