//! The 16-bit format: scalars of 16 bits, lengths and directions of 32 bits, products of at most 32
//! bits.
//!
//! The format suits a processor whose only multiplication has a 32-bit result. The fine evaluation,
//! for steep cones and bright lights, needs the upper half of products of two 32-bit numbers. Such
//! a processor computes an upper half from four products of 16-bit numbers. Falloffs with a real
//! exponent use 64-bit integers in every format.

pub(crate) mod arc;
mod fine_ray;
mod fraction;
mod frame;
mod lobe;
mod offset;
mod quick;

pub(super) use self::fraction::Fraction16;
pub use self::frame::Frame16;
pub(super) use self::offset::{Offset16, is_outside, squared_length};
pub use super::gain::Gain16;
use super::{
    Arithmetic, FixedRamp, Fx16, Fx32, HALF_A_CODE, Length, Light16, Offset, ProjectedPoint, Ray, Rise,
    Scalar, Slopes, Versine, Weight16, Word,
    fine::Fine,
    fine_ray::size,
    operations,
    ramp::{MOST_ZOOM, magnified, zoom},
    rounded, sphere,
};
use crate::{trig, vec3::Vec3};

/// Returns a scalar as an unsigned factor; a negative scalar becomes 0.
#[inline]
fn factor(scalar: Fx16) -> u32 {
    (scalar.to_bits().max(0) as u16).into()
}

/// Converts a scalar between 0 and 1 to a number with 32 fraction bits.
#[inline]
fn fraction(part: Fx16) -> u32 {
    u32::from(part.to_bits() as u16) << 18
}

/// The margin of the bound for rejecting points outside a cone, of which `number::outside_bound`
/// states the reason, and one step for the rounding of the squared cosine.
const OUTSIDE: i16 = 16 + 1;

impl Arithmetic for Fx16 {
    operations!(i16, u16, u32, Light16, Weight16, Gain16, Offset16, Frame16, Steps14);

    type Fraction = Fraction16;
    type Fine = Fine;
    const DIRECTION_ERROR: f32 = 1.55e-5;
    const OUTSIDE_STEP: f32 = Self::STEP;

    fn axis(axis: Vec3<f32>) -> Vec3<Fx32> {
        axis.map(Fx32::from_f32)
    }

    #[inline]
    fn offset(light: Vec3<Length>, point: Vec3<Length>) -> Offset16 {
        Offset16::between(light, point)
    }

    /// Returns zero if the fine evaluation stays within half a linear code, else infinity.
    ///
    /// The rounding error of the fine evaluation need not be added to the direction's error.
    /// [`DIRECTION_ERROR`](Self::DIRECTION_ERROR) is the error of the coarse direction. The error
    /// of the fine direction is smaller by more than the rounding error.
    fn rounding(edge: &Slopes) -> f32 {
        const ROOM: f32 = 0.99 * HALF_A_CODE;
        let fine = edge.angle * 0.25e-6 + edge.fraction * 1e-8 + Self::STEP;
        if fine <= ROOM { 0.0 } else { f32::INFINITY }
    }

    /// Adds the error terms of the coarse evaluation:
    ///
    /// - The relative error of a versine is at most 2.3e-4. This error comes from the rounding of
    ///   the reciprocal length, from the table of reciprocal lengths and from the truncated bits of
    ///   the offset, each at most 9e-5. A versine also has an absolute error of half the square of
    ///   2.3e-4.
    /// - The three components of the difference between direction and axis are rounded to integers:
    ///   together an error of 0.87 units in length.
    /// - The remaining error of the direction is 1.36e-5 radians.
    /// - The falloff's argument `t` and each product of a power are rounded to 15 fraction bits.
    ///   The ramp computes with 16 bits.
    ///
    /// The terms do not have their maxima at the same point: the largest error that a search finds
    /// is 0.84 of the sum of the terms. The bound is 0.9 of this sum.
    fn coarse_error(edge: &Slopes, outer: f32, limit: f32) -> f32 {
        const LENGTH: f32 = 2.3e-4;
        const MET: f32 = 0.9;
        let limit = if limit < outer { limit } else { outer };
        let direction = 1.36e-5 + 0.87 / (1_u32 << (14 + zoom(limit))) as f32;
        // The chord `2 sin(theta / 2)` is not longer than the arc `theta`. So the bound of a narrow
        // cone's derivative with respect to the angle, taken with respect to the chord, also holds
        // for a wide cone.
        let chord = trig::sqrt(2.0 * outer);
        let versine =
            edge.angle * (direction / chord + LENGTH / 2.0) + edge.fraction * (LENGTH * LENGTH / 2.0 / outer);
        MET * (versine + edge.fraction * 3.0 / 65_536.0 + 1.5 * Self::STEP)
    }

    fn fine_ramp(inner: f32, outer: f32, limit: f32) -> FixedRamp {
        FixedRamp::new(inner, outer, limit).into_fine()
    }

    fn zoomed(from: FixedRamp, to: FixedRamp, part: Self) -> (FixedRamp, Self) {
        let (ramp, chords) = from.between(to, fraction(part), MOST_ZOOM);
        (ramp, Self::from_bits((chords.squared_cosine() >> 16) as i16 - OUTSIDE))
    }

    #[inline]
    fn rise(ramp: FixedRamp, versine: Versine) -> Rise<Self> {
        ramp.rise(versine)
    }

    fn fine_below(error: f32, intensity: f32, grows: bool) -> u32 {
        /// Error of a cosine in the coarse evaluation, relative to half a linear code.
        const COSINE: f32 = 2.2e-4 / HALF_A_CODE;
        /// Factor below 1, because the error of a small share is smaller than the bound.
        ///
        /// Light within full scale at a large gain has a small share. With this factor a search
        /// finds errors of up to 0.43 linear codes.
        const BRIGHT: f32 = 0.5556;
        /// Factor above 1, for moving points and for the error of the cosine.
        ///
        /// The error of a moving point jumps where the evaluation changes from coarse to fine. With
        /// this factor a search finds errors of up to 0.48 linear codes against the trend of a
        /// moving point's light; with a factor of 1, up to 0.56 linear codes.
        const MOVING: f32 = 1.04;
        let error = error / HALF_A_CODE;
        let squared = BRIGHT * (MOVING * error).max(COSINE) * intensity;
        if error > 1.0 || (squared > 1.0 && !grows) {
            return u32::MAX;
        }
        if !grows {
            return 0;
        }
        // The squared distance, in units of the square of 2^-16 (the step of a length).
        let squared = ((squared * (1_u64 << 32) as f32) as u64).min((1 << 62) - 1);
        let bits = (u64::BITS - squared.leading_zeros()).div_ceil(2);
        bits << 26 | ((squared << (62 - 2 * bits)) >> 36) as u32
    }

    #[inline]
    fn is_clipped(share: Self, light: Light16) -> bool {
        // The relative error of a share of 1/32 or more is at most 6 %, so light above 1.125
        // exceeds full scale.
        share.to_bits() > 1 << 9 && light.to_bits() > 9 << 11
    }

    #[inline]
    fn weighted_byte(sum: u32) -> Self {
        // `257 / 2^16 = (1 - 2^-16) / 255`. The difference from `1 / 255` changes the result by at
        // most a quarter of a step, so the rounding still gives exactly 1 if all bytes are 255.
        Self::from_bits((((sum >> 10) * 257 + (1 << 15)) >> 16).min(1 << 14) as i16)
    }

    #[inline]
    fn versine_between(a: Vec3<Fx32>, b: Vec3<Fx32>, ramp: FixedRamp) -> Versine {
        let shift = MOST_ZOOM - ramp.zoom + 1;
        // The rounding constant of the difference is subtracted from the second direction. If that
        // is an axis, the subtraction happens once per light. The difference of opposite directions
        // may wrap, but the wrapped value is also far outside every cone.
        let b = b.map(|c| c.to_bits().wrapping_sub(1 << (shift - 1)));
        let difference = a.zip(b, |a, b| a.to_bits().wrapping_sub(b) >> shift);
        if size(difference) >> 15 != 0 {
            return Versine::MAX;
        }
        let squares = difference.map(|c| (c * c) as u32);
        Versine::from_bits(squares.x + squares.y + squares.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::FullOffset;

    /// Light counts as clipped only if it exceeds full scale by more than the error of its share.
    #[test]
    fn clipped_light_is_past_full_scale() {
        let (share, light) = (Fx16::from_bits((1 << 9) + 1), Light16::from_bits);
        let least = (0..1 << 16).find(|&bits| Fx16::is_clipped(share, light(bits)));
        let least = Fx16::light_to_f32(light(least.expect("some light is clipped")));
        assert!((1.07..1.2).contains(&least), "the least clipped light is {least}, expected 1.07 to 1.2");
        assert!(!Fx16::is_clipped(Fx16::from_bits(1 << 9), light(u32::MAX)));
    }

    /// Points are near below the distance whose square `fine_below` encodes.
    ///
    /// For an error of half a linear code, this square is `BRIGHT * MOVING * intensity`.
    #[test]
    fn points_are_near_below_the_encoded_distance() {
        for intensity in [1e-4_f32, 0.01, 0.5, 3.0, 77.0, 4_000.0, 1e6, 1e9] {
            let below = Fx16::fine_below(HALF_A_CODE, intensity, true);
            let distance = trig::sqrt(0.5556 * 1.04 * intensity);
            for i in 0..1_000_u32 {
                let size = distance * (0.9 + 0.2 * i as f32 / 1_000.0);
                let unit = [[1.0, 0.0, 0.0], [0.6, -0.8, 0.0], [-0.48, 0.6, 0.64]][i as usize % 3];
                let point = unit.map(|c| Length::from_f32(c * size));
                let offset = Fx16::offset(Vec3::default(), Vec3::new(point[0], point[1], point[2]));
                let is_open = (size / distance - 1.0).abs() < 0.01;
                assert!(
                    is_open || offset.is_near(below) == (size < distance),
                    "is_near at {size}, expected below {distance}"
                );
            }
        }
    }
}
