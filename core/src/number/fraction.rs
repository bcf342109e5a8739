//! Where a point stands between the edge of a cone and its middle, and what edge profiles make of it; also the cosine of
//! an angle of incidence.
//!
//! A profile magnifies the rounding of its argument by its slope, so a fraction has one bit more than a scalar; it
//! costs nothing, because the products that use it are as wide as before.

use super::{Arithmetic, Knot, RealExponent, Scalar, Share, float, knot::SLOPE_BITS};

/// A number from 0 to 1, one bit finer than the scalar: the argument of an edge profile.
///
/// Made by [`Arithmetic::rise`] and [`Ray::cosine`](super::Ray::cosine) alone, so that it is in its range whatever the input was. In what follows it is called
/// `t`, and `u = 1 - t`.
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
    fn lack(value: Self::Value) -> Self::Value;
    /// `low - (low - high) share`: from `low` to a `high` that is not over it.
    fn mixed(low: Self::Value, high: Self::Value, share: S) -> Self::Value;
    /// One wherever `t` is more than zero.
    fn step(self) -> Self::Value;
    /// `t^2 (3 - 2 t)`: two multiplies.
    fn smooth(self) -> Self::Value;
    /// `t (1 + g u)` for `g` in [-1, 1]: two multiplies.
    fn blend(self, g: S::Weight) -> Self::Value;
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

    #[inline(always)]
    fn lack(value: f32) -> f32 {
        f32::ONE.minus(value)
    }

    #[inline(always)]
    fn mixed(low: f32, high: f32, share: f32) -> f32 {
        low.minus(low.minus(high).times(share))
    }

    #[inline(always)]
    fn complement(self) -> Self {
        Self(1.0 - self.0)
    }

    #[inline(always)]
    fn fine_product(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }

    #[inline(always)]
    fn product(self, other: Self) -> f32 {
        self.0 * other.0
    }

    #[inline(always)]
    fn scalar(self) -> f32 {
        self.0
    }

    fn real_power(self, exponent: RealExponent) -> Self {
        Self(exponent.of_f32(self.0) as f32 * (1.0 / 2_147_483_648.0))
    }

    #[inline(always)]
    fn of(self, scalar: f32) -> f32 {
        scalar * self.0
    }

    #[inline(always)]
    fn step(self) -> f32 {
        if self.0 > 0.0 { 1.0 } else { 0.0 }
    }

    #[inline(always)]
    fn smooth(self) -> f32 {
        float::clamp(self.0 * self.0 * (3.0 - (self.0 + self.0)))
    }

    #[inline(always)]
    fn blend(self, g: f32) -> f32 {
        float::clamp(self.0 * (1.0 + (1.0 - self.0) * g))
    }

    #[inline(always)]
    fn cubic(self, g: f32, h: f32) -> f32 {
        float::clamp(self.0 * (1.0 + (1.0 - self.0) * (g + h * self.0)))
    }

    #[inline(always)]
    fn sample(self, samples: &[u16]) -> f32 {
        let place = (1.0 - self.0) * samples.len().saturating_sub(1) as f32;
        let index = place as usize;
        let (here, next) = neighbours(samples, index);
        let (here, next) = (f32::from(here), f32::from(next));
        float::clamp((here + (next - here) * (place - index as f32)) * (1.0 / 65_535.0))
    }

    #[inline(always)]
    fn along(self, knots: &[Knot]) -> f32 {
        const STEP: f32 = 1.0 / (1 << SLOPE_BITS) as f32;
        let place = (1.0 - self.0) * 65_536.0;
        let knot = Knot::at(knots, place as u32);
        let rise = (place - f32::from(knot.place)) * (knot.slope as f32 * STEP);
        float::clamp((f32::from(knot.value) + rise) * (1.0 / 65_535.0))
    }
}

/// Two neighbouring samples; beyond the last one it is its own neighbour.
#[inline(always)]
pub(super) fn neighbours(samples: &[u16], index: usize) -> (u16, u16) {
    let here = samples.get(index).copied().unwrap_or(0);
    (here, samples.get(index + 1).copied().unwrap_or(here))
}

#[cfg(feature = "fixed")]
pub(super) use fixed_point::{Fraction16, Fraction32};

#[cfg(feature = "fixed")]
mod fixed_point {
    use super::{Fraction, Knot, RealExponent, SLOPE_BITS, neighbours};
    use crate::number::{Arithmetic, Fx16, Fx32};
    use crate::number::{Weight16, Weight32};

    /// A fraction with 15 fraction bits: its products have 30. In a whole register, for a half one has to be cut off
    /// again and again.
    #[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
    pub struct Fraction16(pub(in crate::number) u32);

    /// A fraction with 31 fraction bits: its products have 62.
    #[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
    pub struct Fraction32(pub(in crate::number) u32);

    impl Fraction16 {
        const ONE: u32 = 1 << 15;

        #[inline(always)]
        fn wide(self) -> u32 {
            self.0
        }

        #[inline(always)]
        fn signed(self) -> i32 {
            self.0.cast_signed()
        }

        /// `t (1 + lift)`, `lift` having 15 fraction bits, within [0, 1] whatever the lift: its last rounding may
        /// pass the ends by a step, and weights out of range wrap.
        #[inline(always)]
        fn lifted(self, lift: i32) -> Fx16 {
            let factor = Self::ONE.saturating_add_signed(lift);
            Fx16::from_bits((self.wide().wrapping_mul(factor).wrapping_add(1 << 15) >> 16).min(1 << 14) as i16)
        }
    }

    /// The scalar of a value from 0 to 65,535, which is one: the top bit, added at the bottom, makes it 65,536.
    #[inline(always)]
    fn of_sixteen_bits(value: i32) -> Fx16 {
        Fx16::from_bits(((value + (value >> 15) + 2) >> 2) as i16)
    }

    /// The scalar of a value from 0 to 65,535, which is one, with 31 fraction bits: 2^16 / (2^16 - 1) is
    /// 1 + 2^-16 + 2^-32 + ...
    #[inline(always)]
    fn of_wide_value(value: i64) -> Fx32 {
        let scaled = value + (value >> 16) + (value >> 32);
        Fx32::from_bits(((scaled + (1 << 16)) >> 17) as i32)
    }

    impl Fraction<Fx16> for Fraction16 {
        type Value = Fx16;

        #[inline(always)]
        fn lack(value: Fx16) -> Fx16 {
            Fx16::ONE.minus(value)
        }

        #[inline(always)]
        fn mixed(low: Fx16, high: Fx16, share: Fx16) -> Fx16 {
            low.minus(low.minus(high).times(share))
        }

        #[inline(always)]
        fn complement(self) -> Self {
            Self(Self::ONE - self.wide())
        }

        #[inline(always)]
        fn fine_product(self, other: Self) -> Self {
            Self((self.wide() * other.wide() + (1 << 14)) >> 15)
        }

        #[inline(always)]
        fn product(self, other: Self) -> Fx16 {
            Fx16::from_bits(((self.wide() * other.wide() + (1 << 15)) >> 16) as i16)
        }

        #[inline(always)]
        fn scalar(self) -> Fx16 {
            Fx16::from_bits(((self.wide() + 1) >> 1) as i16)
        }

        fn real_power(self, exponent: RealExponent) -> Self {
            Self(((exponent.of_bits(self.0 << 16) + (1 << 15)) >> 16) as u32)
        }

        #[inline(always)]
        fn of(self, scalar: Fx16) -> Fx16 {
            let scalar = u32::from(scalar.to_bits().cast_unsigned());
            // Masked so that the compiler sees that it is not negative.
            Fx16::from_bits(((self.wide() * scalar + (1 << 14)) >> 15 & 0x7fff) as i16)
        }

        #[inline(always)]
        fn step(self) -> Fx16 {
            if self.0 > 0 { Fx16::ONE } else { Fx16::ZERO }
        }

        #[inline(always)]
        fn smooth(self) -> Fx16 {
            let (t, square) = (self.wide(), self.fine_product(self).wide());
            Fx16::from_bits(((square * (3 * Self::ONE - 2 * t) + (1 << 15)) >> 16).min(1 << 14) as i16)
        }

        #[inline(always)]
        fn blend(self, g: Weight16) -> Fx16 {
            self.lifted(self.complement().signed().wrapping_mul(g.to_bits()).wrapping_add(1 << 13) >> 14)
        }

        #[inline(always)]
        fn cubic(self, g: Weight16, h: Weight16) -> Fx16 {
            let bend = self.signed().wrapping_mul(h.to_bits()).wrapping_add(1 << 14) >> 15;
            let slope = g.to_bits().wrapping_add(bend);
            self.lifted(self.complement().signed().wrapping_mul(slope).wrapping_add(1 << 13) >> 14)
        }

        #[inline(always)]
        fn sample(self, samples: &[u16]) -> Fx16 {
            let place = self.complement().wide().wrapping_mul((samples.len() as u32).saturating_sub(1));
            let (here, next) = neighbours(samples, (place >> 15) as usize);
            let (here, next) = (i32::from(here), i32::from(next));
            let between = (here << 15) + (next - here) * (place & 0x7fff).cast_signed();
            of_sixteen_bits((between + (1 << 14)) >> 15)
        }

        #[inline(always)]
        fn along(self, knots: &[Knot]) -> Fx16 {
            let place = self.complement().wide() << 1;
            let knot = Knot::at(knots, place);
            let beyond = place.wrapping_sub(knot.place.into()).cast_signed();
            let rise = knot.slope.wrapping_mul(beyond).wrapping_add(1 << (SLOPE_BITS - 1)) >> SLOPE_BITS;
            of_sixteen_bits((i32::from(knot.value) + rise).clamp(0, 65_535))
        }
    }

    impl Fraction32 {
        const ONE: u64 = 1 << 31;

        #[inline(always)]
        fn wide(self) -> u64 {
            u64::from(self.0)
        }

        #[inline(always)]
        fn signed(self) -> i64 {
            i64::from(self.0)
        }

        /// As in 16 bits, `lift` having 31 fraction bits.
        #[inline(always)]
        fn lifted(self, lift: i64) -> Fx32 {
            let factor = Self::ONE.saturating_add_signed(lift);
            Fx32::from_bits((self.wide().wrapping_mul(factor).wrapping_add(1 << 31) >> 32).min(1 << 30) as i32)
        }
    }

    impl Fraction<Fx32> for Fraction32 {
        type Value = Fx32;

        #[inline(always)]
        fn lack(value: Fx32) -> Fx32 {
            Fx32::ONE.minus(value)
        }

        #[inline(always)]
        fn mixed(low: Fx32, high: Fx32, share: Fx32) -> Fx32 {
            low.minus(low.minus(high).times(share))
        }

        #[inline(always)]
        fn complement(self) -> Self {
            Self((Self::ONE - self.wide()) as u32)
        }

        #[inline(always)]
        fn fine_product(self, other: Self) -> Self {
            Self(((self.wide() * other.wide() + (1 << 30)) >> 31) as u32)
        }

        #[inline(always)]
        fn product(self, other: Self) -> Fx32 {
            Fx32::from_bits(((self.wide() * other.wide() + (1 << 31)) >> 32) as i32)
        }

        #[inline(always)]
        fn scalar(self) -> Fx32 {
            Fx32::from_bits(((self.0 >> 1) + (self.0 & 1)).cast_signed())
        }

        fn real_power(self, exponent: RealExponent) -> Self {
            Self(exponent.of_bits(self.0) as u32)
        }

        #[inline(always)]
        fn of(self, scalar: Fx32) -> Fx32 {
            let scalar = u64::from(scalar.to_bits().cast_unsigned());
            Fx32::from_bits(((self.wide() * scalar + (1 << 30)) >> 31) as i32)
        }

        #[inline(always)]
        fn step(self) -> Fx32 {
            if self.0 > 0 { Fx32::ONE } else { Fx32::ZERO }
        }

        #[inline(always)]
        fn smooth(self) -> Fx32 {
            let (t, square) = (self.wide(), self.fine_product(self).wide());
            Fx32::from_bits(((square * (3 * Self::ONE - 2 * t) + (1 << 31)) >> 32).min(1 << 30) as i32)
        }

        #[inline(always)]
        fn blend(self, g: Weight32) -> Fx32 {
            self.lifted(self.complement().signed().wrapping_mul(g.to_bits()).wrapping_add(1 << 29) >> 30)
        }

        #[inline(always)]
        fn cubic(self, g: Weight32, h: Weight32) -> Fx32 {
            let bend = self.signed().wrapping_mul(h.to_bits()).wrapping_add(1 << 30) >> 31;
            let slope = g.to_bits().wrapping_add(bend);
            self.lifted(self.complement().signed().wrapping_mul(slope).wrapping_add(1 << 29) >> 30)
        }

        #[inline(always)]
        fn sample(self, samples: &[u16]) -> Fx32 {
            let place = self.complement().wide().wrapping_mul((samples.len() as u64).saturating_sub(1));
            let (here, next) = neighbours(samples, (place >> 31) as usize);
            let (here, next) = (i64::from(here), i64::from(next));
            of_wide_value((here << 31) + (next - here) * (place & 0x7fff_ffff).cast_signed())
        }

        #[inline(always)]
        fn along(self, knots: &[Knot]) -> Fx32 {
            let place = self.complement().0;
            let knot = Knot::at(knots, place >> 15);
            let beyond = i64::from(place) - (i64::from(knot.place) << 15);
            let between = (i64::from(knot.value) << 30) + i64::from(knot.slope) * beyond;
            of_wide_value(between.clamp(0, 65_535 << 30) << 1)
        }
    }
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use super::*;
    use crate::{
        Fx16,
        falloff::{Cubic, Curve, Falloff, Hard, InvertedPower, Linear, Power, Quadratic, Smooth, Soft},
    };

    extern crate std;

    /// Every `t` of 16 bits: both ends exact, within [0, 1], the largest error in steps, and the largest fall
    /// towards the middle in steps.
    fn over_all_t<P: Falloff>(profile: P, exact: impl Fn(f64) -> f64) -> (f64, i32) {
        let curve = profile.compile::<Fx16>();
        let at = |t: u16| i32::from(curve.intensity(Fraction16(t.into())).to_bits());
        assert_eq!((at(0), at(1 << 15)), (0, 1 << 14), "{profile:?}");
        (0..=1 << 15).fold((0.0, 0), |(error, fall), t: u16| {
            let (here, next) = (at(t), at((t + 1).min(1 << 15)));
            assert!((0..=1 << 14).contains(&here), "{profile:?} {t}: {here}");
            let difference = f64::from(here) - 16_384.0 * exact(f64::from(t) / 32_768.0);
            (f64::max(error, difference.abs()), fall.max(here - next))
        })
    }

    /// Exhaustive: half a step is the last rounding; what is over it is that of the products before.
    #[test]
    fn sixteen_bits_are_monotone_and_keep_their_errors() {
        let within = |(error, fall): (f64, i32), bound: f64, most_fall: i32| {
            assert!(error <= bound && error > bound / 2.0, "{error}");
            assert!(fall <= most_fall, "falls by {fall}");
        };
        within(over_all_t(Linear, |t| t), 0.5, 0);
        within(over_all_t(Soft, |t| t * t), 0.5, 0);
        within(over_all_t(Hard, |t| 1.0 - (1.0 - t) * (1.0 - t)), 0.5, 0);
        within(over_all_t(Power::<4>, |t| t.powi(4)), 1.0, 0);
        within(over_all_t(Power::<15>, |t| t.powi(15)), 3.5, 0);
        within(over_all_t(Power::<16>, |t| t.powi(16)), 4.0, 0);
        within(over_all_t(InvertedPower::<4>, |t| 1.0 - (1.0 - t).powi(4)), 1.0, 0);
        within(over_all_t(Smooth, |t| t * t * (3.0 - 2.0 * t)), 1.3, 1);
    }

    /// Every blend on a grid of 1/32 and every monotone cubic on one of 1/8, over every `t`.
    #[test]
    fn all_blends_and_cubics_fall_by_a_step_at_most() {
        let (mut worst, mut fall) = (0.0_f64, 0);
        for slope in 0..=64_u8 {
            let a = f64::from(slope) / 32.0;
            let blend = Quadratic::new(a as f32).expect("sound");
            let (error, falls) = over_all_t(blend, |t| t * (a + (1.0 - a) * t));
            (worst, fall) = (worst.max(error), fall.max(falls));
        }
        assert!((0.5..=0.8).contains(&worst) && fall <= 1, "blends: {worst}, fall by {fall}");
        (worst, fall) = (0.0, 0);
        let mut count = 0;
        for (edge, middle) in (0..=32_u8).flat_map(|edge| (0..=32_u8).map(move |middle| (edge, middle))) {
            let slopes = (f32::from(edge) / 8.0, f32::from(middle) / 8.0);
            let Ok(cubic) = Cubic::with_slopes(slopes.0, slopes.1) else { continue };
            let [a, b, c] = cubic.coefficients().map(f64::from);
            let (error, falls) = over_all_t(cubic, |t| t * (a + t * (b + t * c)));
            (worst, fall, count) = (worst.max(error), fall.max(falls), count + 1);
        }
        assert!(count > 500, "only {count} cubics are monotone");
        assert!((0.5..=1.1).contains(&worst) && fall <= 1, "cubics: {worst}, fall by {fall}");
    }

    /// Weights that no profile has end in [0, 1] all the same.
    #[test]
    fn every_weight_has_an_answer() {
        use crate::Fx32;
        use crate::number::{Weight16, Weight32};
        let weights = [i32::MIN, -65_536, -1, 0, 65_536, i32::MAX].map(Weight16::from_bits);
        let wide = [i64::MIN, -(1 << 32), -1, 0, 1 << 32, i64::MAX].map(Weight32::from_bits);
        for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
            for t in [0, 1, 12_345, 16_384, 32_767, 32_768_u16] {
                let (narrow, fine) = (Fraction16(t.into()), Fraction32(u32::from(t) << 16));
                for value in [narrow.blend(weights[i]), narrow.cubic(weights[i], weights[j])] {
                    assert!((Fx16::ZERO..=Fx16::ONE).contains(&value));
                }
                for value in [fine.blend(wide[i]), fine.cubic(wide[i], wide[j])] {
                    assert!((Fx32::ZERO..=Fx32::ONE).contains(&value));
                }
            }
        }
        assert_eq!(
            (Fx16::weight(f32::NAN), Fx16::weight(9.0)),
            (Weight16::ZERO, Weight16::from_bits(4 << 14))
        );
    }
}
