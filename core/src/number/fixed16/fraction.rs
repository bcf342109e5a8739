//! Arguments of falloffs with 15 fraction bits, and the falloffs' formulas.

use crate::number::{
    Fraction, Fx16, RealExponent, Weight16,
    fraction::neighbours,
    knot::{Knot, SLOPE_BITS},
};

/// A fraction with 15 fraction bits; a product of two has 30.
///
/// The fraction is stored in 32 bits, because a 16-bit value would need a truncation after each
/// operation.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub struct Fraction16(pub(in crate::number) u32);

impl Fraction16 {
    /// Number of fraction bits.
    const BITS: u32 = 15;
    const ONE: u32 = 1 << Self::BITS;
    /// Half a step of a scalar, in units of a product of two fractions.
    const HALF: u32 = 1 << Self::BITS;

    /// Returns `t (1 + lift)` for this fraction `t`, capped at 1. The lift has as many fraction bits
    /// as `t`.
    ///
    /// The cap is needed because the last rounding may exceed 1 by one step, and because the lift
    /// wraps for a coefficient that is out of range.
    #[inline]
    fn lifted(self, lift: i32) -> Fx16 {
        Self::capped(self.0.wrapping_mul(Self::ONE.saturating_add_signed(lift)))
    }

    /// Converts a product of two fractions to a scalar, capped at 1.
    #[inline]
    fn capped(product: u32) -> Fx16 {
        let rounded = product.wrapping_add(Self::HALF) >> (Self::BITS + 1);
        Fx16::from_bits(rounded.min(1 << Fx16::FRACTION_BITS) as _)
    }

    /// Converts a table sample, shifted left by 15 bits, to a scalar. The sample 65,535 means 1.
    #[inline]
    fn of_value(value: i32) -> Fx16 {
        Self::of_sixteen_bits((value + (1 << 14)) >> 15)
    }

    /// Converts a table sample to a scalar. The sample 65,535 means 1.
    ///
    /// The sum of the sample and its top bit maps 65,535 to 65,536.
    #[inline]
    fn of_sixteen_bits(value: i32) -> Fx16 {
        Fx16::from_bits(((value + (value >> 15) + 2) >> 2) as i16)
    }
}

impl Fraction<Fx16> for Fraction16 {
    type Value = Fx16;

    #[inline]
    fn complement(self) -> Self {
        Self(Self::ONE - self.0)
    }

    #[inline]
    fn fine_product(self, other: Self) -> Self {
        Self((self.0 * other.0 + Self::HALF / 2) >> Self::BITS)
    }

    #[inline]
    fn product(self, other: Self) -> Fx16 {
        Fx16::from_bits(((self.0 * other.0 + Self::HALF) >> (Self::BITS + 1)) as _)
    }

    #[inline]
    fn scalar(self) -> Fx16 {
        Fx16::from_bits(((self.0 + 1) >> 1) as i16)
    }

    fn real_power(self, exponent: RealExponent) -> Self {
        const MORE: u32 = 31 - Fraction16::BITS;
        Self(((exponent.of_bits(self.0 << MORE) + (1 << MORE >> 1)) >> MORE) as u32)
    }

    #[inline]
    fn of(self, scalar: Fx16) -> Fx16 {
        let scalar = u32::from(scalar.to_bits() as u16);
        let product = (self.0 * scalar + Self::HALF / 2) >> Self::BITS;
        // The mask shows the compiler that the value is not negative.
        Fx16::from_bits((product & (Self::ONE - 1)) as _)
    }

    #[inline]
    fn step(self) -> Fx16 {
        if self.0 > 0 { Fx16::ONE } else { Fx16::ZERO }
    }

    #[inline]
    fn smooth(self) -> Fx16 {
        let square = self.fine_product(self).0;
        Self::capped(square * (3 * Self::ONE - 2 * self.0))
    }

    #[inline]
    fn quadratic(self, g: Weight16) -> Fx16 {
        const HALF: i32 = 1 << (Weight16::FRACTION_BITS - 1);
        let lift = (self.complement().0 as i32).wrapping_mul(g.to_bits());
        self.lifted(lift.wrapping_add(HALF) >> Weight16::FRACTION_BITS)
    }

    #[inline]
    fn cubic(self, g: Weight16, h: Weight16) -> Fx16 {
        const HALF: i32 = 1 << Weight16::FRACTION_BITS;
        let bend = (self.0 as i32).wrapping_mul(h.to_bits()).wrapping_add(HALF) >> Self::BITS;
        self.quadratic(Weight16::from_bits(g.to_bits().wrapping_add(bend)))
    }

    #[inline]
    fn sample(self, samples: &[u16]) -> Fx16 {
        let last = (samples.len() as u32).saturating_sub(1);
        let place = self.complement().0.wrapping_mul(last);
        let (here, next) = neighbours(samples, (place >> Self::BITS) as usize);
        let (here, next) = (i32::from(here), i32::from(next));
        let share = (place & (Self::ONE - 1)) as i32;
        Self::of_value((here << Self::BITS) + (next - here) * share)
    }

    /// The product of a line's slope and the distance from its start has too many bits to be added
    /// to the start value, so the product is rounded first.
    #[inline]
    fn along(self, knots: &[Knot]) -> Fx16 {
        let place = self.complement().0 << 1;
        let knot = Knot::at(knots, place);
        let beyond = place.wrapping_sub(knot.place.into()) as i32;
        let rise = knot.slope.wrapping_mul(beyond).wrapping_add(1 << (SLOPE_BITS - 1)) >> SLOPE_BITS;
        Self::of_sixteen_bits((i32::from(knot.value) + rise).clamp(0, 65_535))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::falloff::{
        Cubic, Curve, Falloff, Hard, InvertedPower, Linear, Power, Quadratic, Smooth, Soft,
    };
    use crate::number::Arithmetic as _;

    extern crate std;

    /// Evaluates a falloff at every `t`, and checks that both ends are exact and all values in
    /// `[0, 1]`.
    ///
    /// Returns the largest error and the largest decrease towards the axis, both in steps of `Fx16`
    /// (2^-14).
    fn over_all_t<P: Falloff>(falloff: P, exact: impl Fn(f64) -> f64) -> (f64, i32) {
        let curve = falloff.compile::<Fx16>();
        let at = |t: u16| i32::from(curve.intensity(Fraction16(t.into())).to_bits());
        assert_eq!((at(0), at(1 << 15)), (0, 1 << 14), "{falloff:?}");
        (0..=1 << 15).fold((0.0, 0), |(error, fall), t: u16| {
            let (here, next) = (at(t), at((t + 1).min(1 << 15)));
            assert!((0..=1 << 14).contains(&here), "{falloff:?} {t}: {here}, expected here in 0..=1 << 14");
            let difference = f64::from(here) - 16_384.0 * exact(f64::from(t) / 32_768.0);
            (f64::max(error, difference.abs()), fall.max(here - next))
        })
    }

    /// Exhaustive. The last rounding contributes half a step to the error; the rest of the error
    /// comes from the products before the last rounding.
    #[test]
    fn sixteen_bits_are_monotone_and_keep_their_errors() {
        let within = |(error, fall): (f64, i32), bound: f64, most_fall: i32| {
            assert!(
                error <= bound && error > bound / 2.0,
                "error {error}, expected at most {bound} and more than half of it"
            );
            assert!(fall <= most_fall, "falls by {fall}, expected at most {most_fall}");
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

    /// Tests, at every `t`, quadratics with slopes in steps of 1/32 and monotone cubics with slopes
    /// in steps of 1/8.
    #[test]
    fn all_blends_and_cubics_fall_by_a_step_at_most() {
        let (mut worst, mut fall) = (0.0_f64, 0);
        for slope in 0..=64_u8 {
            let a = f64::from(slope) / 32.0;
            let quadratic = Quadratic::new(a as f32).expect("sound");
            let (error, falls) = over_all_t(quadratic, |t| t * (a + (1.0 - a) * t));
            (worst, fall) = (worst.max(error), fall.max(falls));
        }
        assert!((0.5..=0.8).contains(&worst) && fall <= 1, "quadratics: {worst}, fall by {fall}");
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

    /// Coefficients that no falloff has also give results in `[0, 1]`.
    #[test]
    fn every_weight_has_an_answer() {
        let weights = [i32::MIN, -65_536, -1, 0, 65_536, i32::MAX].map(Weight16::from_bits);
        for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
            for t in [0, 1, 12_345, 16_384, 32_767, 32_768_u16] {
                let narrow = Fraction16(t.into());
                for value in [narrow.quadratic(weights[i]), narrow.cubic(weights[i], weights[j])] {
                    assert!((Fx16::ZERO..=Fx16::ONE).contains(&value));
                }
            }
        }
        assert_eq!(
            (Fx16::weight(f32::NAN), Fx16::weight(9.0)),
            (Weight16::ZERO, Weight16::from_bits(4 << 14))
        );
    }

    /// Evaluates lines of several slopes at every `t`. The rise of a line is rounded to nearest.
    #[test]
    fn a_line_is_the_nearest_value() {
        for slope in [-32_768, -12_345, -1, 0, 1, 7_777, 32_767] {
            let knot = Knot::from_bits(0, if slope < 0 { 65_535 } else { 0 }, slope);
            for t in 0..=1 << 15_u32 {
                let beyond = f64::from((1 << 15) - t) * 2.0;
                let exact = f64::from(knot.value) + (f64::from(slope) * beyond / 32_768.0 + 0.5).floor();
                let found = Fraction16(t).along(&[knot]);
                assert_eq!(
                    found,
                    Fraction16::of_sixteen_bits(exact.clamp(0.0, 65_535.0) as i32),
                    "{slope} {t}"
                );
            }
        }
    }

    #[test]
    fn a_step_is_full_just_inside_its_edge() {
        assert_eq!((Fraction16(0).step(), Fraction16(1).step()), (Fx16::ZERO, Fx16::ONE));
    }
}
