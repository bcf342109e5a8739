//! The quick evaluation in f32: an estimate of the reciprocal square root replaces a correctly
//! rounded root and a division.

use super::{
    FloatRamp,
    offset::{FloatOffset, FloatRay},
};
use crate::number::{Arithmetic, FullOffset, Offset, Quick, Slopes};
use crate::{trig, vec3::Vec3};

/// Vector from a point back to the light.
#[derive(Clone, Copy, Debug)]
pub struct QuickFloatOffset(FloatOffset);

/// Returns `1 / sqrt(x)` for a normal number `x > 0`, with a relative error <= 2.6e-5 (exhaustive
/// over two binades). For any other `x` the result is unspecified.
#[inline]
fn inverse_sqrt(x: f32) -> f32 {
    // Halving and negating the exponent in the integer representation gives `1 / sqrt(x)` with an
    // error of 3.5 % (Lomont 2003, "Fast Inverse Square Root").
    // The difference wraps for a NaN with its sign bit set.
    let seed = f32::from_bits(0x5f37_59df_u32.wrapping_sub(x.to_bits() >> 1));
    // The quadratic in `s` approximates `1/sqrt(s)` with the least relative error, 2.5e-5, over all
    // `s` that the seed can give.
    let s = x * seed * seed;
    seed * (1.876_617 + s * (-1.252_138 + s * 0.375_521_3))
}

impl Quick for f32 {
    type QuickOffset = QuickFloatOffset;

    #[inline]
    fn quick_offset(light: Vec3<f32>, point: Vec3<f32>) -> QuickFloatOffset {
        QuickFloatOffset(f32::offset(light, point))
    }

    fn quick_axis(axis: Vec3<f32>) -> Vec3<f32> {
        axis
    }

    fn quick_ramp(inner: f32, outer: f32, limit: f32) -> FloatRamp {
        f32::ramp(inner, outer, limit)
    }

    fn quick_zoomed(from: FloatRamp, to: FloatRamp, part: f32) -> FloatRamp {
        from.between(to, part)
    }

    fn quick_error(edge: &Slopes, outer: f32) -> f32 {
        const LENGTH: f32 = 2.6e-5;
        let chord = trig::sqrt(2.0 * outer);
        edge.angle * (Self::DIRECTION_ERROR / chord + LENGTH / 2.0)
            + edge.fraction * (LENGTH * LENGTH / 2.0 / outer)
            + 3.0 * LENGTH
    }
}

impl Offset<f32> for QuickFloatOffset {
    type Ray = FloatRay;
    type Facing = f32;

    #[inline]
    fn facing(&self, normal: Vec3<f32>) -> f32 {
        self.0.facing(normal)
    }

    #[inline]
    fn faces_away(facing: f32) -> bool {
        FloatOffset::faces_away(facing)
    }

    #[inline]
    fn squared_distance(&self) -> f32 {
        self.0.squared_distance()
    }

    #[inline]
    fn ray(&self) -> FloatRay {
        self.0.ray_of(inverse_sqrt(self.squared_distance()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    extern crate std;

    #[test]
    fn an_estimate_keeps_its_stated_error() {
        let stride = if std::env::var_os("LUMINAIRE_FULL").is_some() { 1 } else { 61 };
        let worst = (0x3f80_0000..0x4080_0000_u32)
            .step_by(stride)
            .map(f32::from_bits)
            .map(|x| (f64::from(inverse_sqrt(x)) * f64::from(x).sqrt() - 1.0).abs())
            .fold(0.0, f64::max);
        assert!((2.0e-5..=2.6e-5).contains(&worst), "worst relative error {worst:e}");
    }
}
