//! The quick evaluation of the 32-bit format.
//!
//! The quick evaluation uses the direction of the 16-bit format's fine evaluation, and 32-bit
//! products instead of 64-bit products.

use super::{fraction, offset::Offset32};
use crate::number::{
    Fx32, Gain32, Length, Light32, Offset, Quick, Ray, Slopes, cold_path,
    fine::{self, Fine},
    fine_ray::{FineRay, size},
    fixed16::{MOST_ZOOM, Ramp16},
    product::{high_half, high_square, signed_high_half},
    root,
};
use crate::trig;
use crate::vec3::Vec3;

/// Number of lower bits of an offset that the square root and the early-out do not use.
const DROPPED: u32 = 16;

/// Bit length up to which an offset is too short for the common path.
const SHORT: u32 = 16;

/// Offset from a light to a point, scaled until its largest component has 31 bits.
#[derive(Clone, Copy, Debug)]
pub struct QuickOffset32 {
    way: Vec3<i32>,
    /// Bit length of the largest component before scaling.
    bits: u32,
}

impl QuickOffset32 {
    #[inline]
    fn between(light: Vec3<Length>, point: Vec3<Length>) -> Self {
        let way = point.zip(light, |p, l| p.to_bits().wrapping_sub(l.to_bits()));
        // As in the 16-bit format, a difference that wraps has more than 23 bits if the light is
        // within 32,639, so this test detects the wrap.
        let above = size(way) >> SHORT;
        if above == 0 || above >= 128 {
            cold_path();
            return Self::near_or_far(light, point);
        }
        let bits = root::ilog2_of_seven_bits(above) + SHORT + 1;
        Self { way: way.map(|c| c << (31 - bits)), bits }
    }

    /// Returns an offset whose largest component is less than one unit, or 128 units and more.
    #[cold]
    #[inline(never)]
    fn near_or_far(light: Vec3<Length>, point: Vec3<Length>) -> Self {
        let Offset32 { way, bits } = Offset32::between(light, point);
        Self { way, bits }
    }

    /// Returns the upper 15 bits and the sign of each component.
    #[inline]
    fn coarse(&self) -> Vec3<i32> {
        self.way.map(|c| c >> DROPPED)
    }
}

impl Quick for Fx32 {
    type QuickOffset = QuickOffset32;
    type QuickRamp = Ramp16;

    #[inline]
    fn quick_offset(light: Vec3<Length>, point: Vec3<Length>) -> QuickOffset32 {
        QuickOffset32::between(light, point)
    }

    fn quick_axis(axis: Vec3<Fx32>) -> Vec3<Fx32> {
        axis
    }

    fn quick_ramp(inner: f32, outer: f32, limit: f32) -> Ramp16 {
        Ramp16::new(inner, outer, limit)
    }

    fn quick_zoomed(from: Ramp16, to: Ramp16, part: Self) -> Ramp16 {
        from.between(to, fraction(part), MOST_ZOOM).0
    }

    /// The versines computed at set-up are `f32`, with a relative error of at most 4e-7, as in the
    /// standard evaluation.
    fn quick_error(edge: &Slopes, outer: f32) -> f32 {
        const LENGTH: f32 = 4e-8;
        const DIRECTION: f32 = 3e-9;
        let chord = trig::sqrt(2.0 * outer);
        edge.angle * (DIRECTION / chord + 0.21e-6 + LENGTH / 2.0) + edge.fraction * 3e-9 + 3.0 * LENGTH
    }
}

impl Offset<Fx32> for QuickOffset32 {
    type Ray = FineRay;
    /// The inner product of the normal and the offset of 15 bits, with 14 fraction bits.
    ///
    /// The lower bits of normal and offset are dropped before the product.
    type Facing = i64;

    #[inline]
    fn facing(&self, normal: Vec3<Fx32>) -> i64 {
        let products = normal.zip(self.coarse(), |n, v| (n.to_bits() >> 16).wrapping_mul(v));
        products.x.wrapping_add(products.y).wrapping_add(products.z).into()
    }

    /// Returns whether the surface certainly faces away from the light.
    ///
    /// The truncated bits of a unit normal and of the offset change the inner product by less than
    /// `sqrt(3) 2^15 + sqrt(3) 2^14`.
    #[inline]
    fn faces_away(facing: i64) -> bool {
        facing >= 1 << 17
    }

    #[inline]
    fn squared_distance(&self) -> Gain32 {
        let squares = self.way.map(high_square);
        Gain32::normalised((squares.x + squares.y + squares.z).into(), 62 - 2 * self.bits as i32)
    }

    #[inline(always)]
    fn ray(&self) -> FineRay {
        let squares = self.coarse().map(|c| (c * c) as u32);
        let squared = squares.x.wrapping_add(squares.y).wrapping_add(squares.z);
        FineRay::new(self.way, root::quick_inverse_sqrt_16(squared), self.bits)
    }
}

impl Ray<Fx32> for FineRay {
    type Fraction = Fine;
    type Share = Fine;
    type Ramp = Ramp16;

    #[inline]
    fn distance(&self) -> Gain32 {
        Gain32::normalised(self.length().into(), 47 - self.bits)
    }

    #[inline]
    fn direction(&self) -> Vec3<Fx32> {
        self.unit()
    }

    #[inline(always)]
    fn rise(&self, axis: Vec3<Fx32>, ramp: Ramp16) -> Fine {
        ramp.rise_finely(self.versine(axis, ramp))
    }

    /// The cosine is capped at 1, also for normals longer than 1.
    #[inline]
    fn cosine(&self, _: i64, normal: Vec3<Fx32>) -> Fine {
        // Half of a normal's component fits 30 bits and a sign, for normals of any length.
        let products = self.direction.zip(normal, |d, n| signed_high_half(d, n.to_bits() >> 1));
        let along = products.x + products.y + products.z;
        Fine(along.min(0).unsigned_abs().min(1 << 27) << 4)
    }

    #[inline]
    fn expose(&self, share: Fine, gain: Gain32) -> Light32 {
        let here = self.attenuated(gain.mantissa << 4);
        fine::light(high_half(share.0, here), gain.shift + 2 * self.bits - 61)
    }
}
