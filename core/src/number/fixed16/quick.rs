//! The quick evaluation of the 16-bit format.
//!
//! Its offsets have 15 bits instead of 17, and its directions 14 fraction bits in every cone. No
//! test finds the points that need more bits.
//!
//! In the comments `v` is the offset, scaled until its largest component has 15 bits, and `|v|` is
//! its length.

use super::{
    Fraction16, factor, fraction,
    offset::{Offset16, squared_length},
};
use crate::number::{
    FixedRamp, Fx16, Fx32, Gain16, Length, Light16, Offset, Quick, Ray, Scalar, Slopes, Versine, cold_path,
    fine_ray::size, product::high_product, root,
};
use crate::trig;
use crate::vec3::Vec3;

/// Bit length of the largest component of `v`.
const BITS: u32 = 15;

/// Number of lower bits that are dropped from a component of a direction.
const DROPPED: u32 = 16;

/// Rounding bias added to a direction for the truncated bits of `v`.
///
/// The bias is three eighths of the largest reciprocal length, as in the standard evaluation.
const CUT_OFF: i32 = 24_576;

/// Offset from a light to a point: `v`, and the bit length of its largest component before scaling.
#[derive(Clone, Copy, Debug)]
pub struct QuickOffset16 {
    way: Vec3<i32>,
    bits: u32,
}

/// Unit direction and reciprocal distance.
#[derive(Clone, Copy, Debug)]
pub struct QuickRay16 {
    offset: QuickOffset16,
    squared: u32,
    /// `2^30 / |v|`, of 15 or 16 bits.
    reciprocal: u32,
}

impl QuickOffset16 {
    #[inline]
    fn between(light: Vec3<Length>, point: Vec3<Length>) -> Self {
        let way = point.zip(light, |p, l| p.to_bits().wrapping_sub(l.to_bits()));
        // As in the standard evaluation, a difference that wraps has more than 24 bits, so this
        // test detects the wrap.
        let above = size(way) >> BITS;
        if above == 0 || above >= 128 {
            cold_path();
            return Self::near_or_far(light, point);
        }
        // The shift is at most 7; the mask shows this to the compiler.
        let shift = (root::ilog2_of_seven_bits(above) + 1) & 7;
        Self { way: way.map(|c| c >> shift), bits: shift + BITS }
    }

    /// Returns an offset whose largest component is less than half a unit, or 64 units and more.
    #[cold]
    #[inline(never)]
    fn near_or_far(light: Vec3<Length>, point: Vec3<Length>) -> Self {
        let (way, bits) = Offset16::between(light, point).scaled_to_15_bits();
        Self { way, bits }
    }
}

impl Quick for Fx16 {
    type QuickOffset = QuickOffset16;

    #[inline]
    fn quick_offset(light: Vec3<Length>, point: Vec3<Length>) -> QuickOffset16 {
        QuickOffset16::between(light, point)
    }

    /// Applies to the axis, once per light, all rounding constants of the difference between
    /// direction and axis.
    fn quick_axis(axis: Vec3<Fx32>) -> Vec3<Fx32> {
        axis.map(|c| Fx32::from_bits(c.to_bits().wrapping_sub(CUT_OFF + (1 << (DROPPED - 1)))))
    }

    fn quick_ramp(inner: f32, outer: f32, limit: f32) -> FixedRamp {
        FixedRamp::with_zoom(inner, outer, limit, 0)
    }

    fn quick_zoomed(from: FixedRamp, to: FixedRamp, part: Self) -> FixedRamp {
        from.between(to, fraction(part), 0).0
    }

    fn quick_error(edge: &Slopes, outer: f32) -> f32 {
        const LENGTH: f32 = 2.0e-4;
        const DIRECTION: f32 = 0.9e-4;
        let chord = trig::sqrt(2.0 * outer);
        edge.angle * (DIRECTION / chord + LENGTH / 2.0)
            + edge.fraction * (LENGTH * LENGTH / 2.0 / outer + 3.0 / 65_536.0)
            + 3.0 * LENGTH
            + 2.5 * Self::STEP
    }
}

impl Offset<Fx16> for QuickOffset16 {
    type Ray = QuickRay16;
    type Facing = i32;

    #[inline]
    fn facing(&self, normal: Vec3<Fx16>) -> i32 {
        let products = normal.zip(self.way, |n, v| i32::from(n.to_bits()) * v);
        products.x.wrapping_add(products.y).wrapping_add(products.z)
    }

    #[inline]
    fn faces_away(facing: i32) -> bool {
        facing >= 0
    }

    #[inline]
    fn squared_distance(&self) -> Gain16 {
        Gain16::normalised(squared_length(self.way), 62 - 2 * self.bits as i32)
    }

    #[inline]
    fn ray(&self) -> QuickRay16 {
        let squared = squared_length(self.way);
        QuickRay16 { offset: *self, squared, reciprocal: root::quick_inverse_sqrt_16(squared) }
    }
}

impl QuickRay16 {
    /// Returns the direction with 30 fraction bits, before any rounding.
    #[inline]
    fn product(&self) -> Vec3<i32> {
        self.offset.way.map(|c| c.wrapping_mul(self.reciprocal as i32))
    }
}

impl Ray<Fx16> for QuickRay16 {
    type Fraction = Fraction16;
    type Share = Fx16;

    #[inline]
    fn distance(&self) -> Gain16 {
        Gain16::normalised(high_product(self.squared, self.reciprocal), 45 - self.offset.bits as i32)
    }

    #[inline]
    fn direction(&self) -> Vec3<Fx32> {
        self.product().map(|c| Fx32::from_bits(c.wrapping_add(CUT_OFF)))
    }

    /// `axis` is the result of [`Quick::quick_axis`]. Each component of the difference between
    /// direction and axis has at most 15 bits and a sign, so the sum of the squares fits 32 bits
    /// for opposite directions, too.
    #[inline]
    fn rise(&self, axis: Vec3<Fx32>, ramp: FixedRamp) -> Fraction16 {
        let squares = self.product().zip(axis, |d, s| {
            let difference = d.wrapping_sub(s.to_bits()) >> DROPPED;
            difference.wrapping_mul(difference) as u32
        });
        let squared = squares.x.wrapping_add(squares.y).wrapping_add(squares.z);
        ramp.rise_coarsely(Versine::from_bits(squared))
    }

    /// The result is over 1 for a normal that is longer than 1, and at most 2.
    #[inline]
    fn cosine(&self, facing: i32, _: Vec3<Fx16>) -> Fraction16 {
        let along = facing.min(0).unsigned_abs() >> 13;
        Fraction16(along.wrapping_mul(self.reciprocal) >> 16)
    }

    #[inline]
    fn expose(&self, fraction: Fx16, gain: Gain16) -> Light16 {
        // `reciprocal`, `squared` and `mantissa` have at most 16, 16 and 18 bits, so every product
        // fits 32 bits.
        let squared = (self.reciprocal * self.reciprocal) >> 16;
        let mantissa = (gain.factor() * squared) >> 14;
        let shift = gain.scale() + 2 * self.offset.bits as i32 - 32;
        Light16::shifted(factor(fraction).wrapping_mul(mantissa), shift)
    }
}
