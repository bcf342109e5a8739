//! Offset from a light to a point in the 32-bit format, and its direction and length.

use super::wide;
use crate::number::{
    FixedRamp, FullOffset, Fx32, Gain32, Length, Light32, Offset, Ray, cold_path,
    fine::{self, Fine},
    fine_ray::{self, FineRay, size},
    fixed16::{is_outside, squared_length},
    product::{high_half, signed_high_half},
    root,
};
use crate::vec3::Vec3;

/// Number of lower bits of an offset that the square root and the early-outs do not use.
const DROPPED: u32 = 16;

/// Bit length up to which an offset is too short for the common path.
const SHORT: u32 = 16;

/// Offset from a light to a point, scaled until its largest component has 31 bits.
#[derive(Clone, Copy, Debug)]
pub struct Offset32 {
    pub(super) way: Vec3<i32>,
    /// Bit length of the largest component before scaling, at least 1.
    pub(super) bits: u32,
}

impl Offset32 {
    /// Returns the offset from a light to a point.
    #[inline]
    pub(super) fn between(light: Vec3<Length>, point: Vec3<Length>) -> Self {
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
        let [p, l] = [point, light].map(|place| place.map(Length::to_bits));
        let way = (p.x.checked_sub(l.x), p.y.checked_sub(l.y), p.z.checked_sub(l.z));
        if let (Some(x), Some(y), Some(z)) = way {
            return Self::new(Vec3::new(x, y, z));
        }
        let half = |p, l| ((i64::from(p) - i64::from(l) + 1) >> 1).min(i32::MAX.into()) as i32;
        let Self { way, bits } = Self::new(p.zip(l, half));
        Self { way, bits: bits + 1 }
    }

    /// Returns the offset for a vector of any size.
    #[inline]
    pub(super) fn new(way: Vec3<i32>) -> Self {
        let bits = root::bit_length(size(way));
        Self { way: way.map(|c| c << (31 - bits)), bits }
    }

    /// Returns the upper 15 bits and the sign of each component.
    #[inline]
    fn coarse(&self) -> Vec3<i32> {
        self.way.map(|c| c >> DROPPED)
    }

    /// Returns the unit vector along the offset, each component within one unit of 2^-30.
    ///
    /// The axis of a light has this accuracy. It is computed once, with 64-bit products.
    pub(super) fn unit(&self) -> Vec3<Fx32> {
        let squares = self.way.map(|c| wide(c, c) as u64);
        let squared = squares.x + squares.y + squares.z;
        let reciprocal = if squared >= 1 << 62 {
            root::inverse_sqrt_32(squared) >> 1
        } else if squared >= 1 << 60 {
            root::inverse_sqrt_32(squared << 2)
        } else {
            0
        };
        self.way.map(|c| {
            let product = i64::from(c) * reciprocal as i64;
            Fx32::from_bits(((product + (1 << 31)) >> 32) as i32)
        })
    }
}

impl Offset<Fx32> for Offset32 {
    type Ray = FineRay;
    /// The inner product of the normal and the offset of 15 bits, with 13 fraction bits.
    ///
    /// The lower bits of normal and offset are dropped before the product, so that the sum fits 32
    /// bits for a normal of any length.
    type Facing = i32;

    #[inline]
    fn facing(&self, normal: Vec3<Fx32>) -> i32 {
        let products = normal.zip(self.coarse(), |n, v| (n.to_bits() >> 17) * v);
        products.x + products.y + products.z
    }

    /// Returns whether the surface certainly faces away from the light.
    ///
    /// The truncated bits of the normal change the inner product by less than `3 * 2^15`, and those
    /// of the offset by less than `3 * 2^14`.
    #[inline]
    fn faces_away(facing: i32) -> bool {
        facing >= 9 << 14
    }

    #[inline]
    fn squared_distance(&self) -> Gain32 {
        Gain32::normalised(fine_ray::squared_length(self.way, 0).into(), 62 - 2 * self.bits as i32)
    }

    #[inline(always)]
    fn ray(&self) -> FineRay {
        FineRay::new(self.way, root::quick_inverse_sqrt_16(squared_length(self.coarse())), self.bits)
    }
}

impl FullOffset<Fx32> for Offset32 {
    type FineRay = FineRay;

    #[inline]
    fn is_outside(&self, axis: Vec3<Fx32>, bound: Fx32) -> bool {
        is_outside(self.coarse(), axis, bound.to_bits() >> 16)
    }

    #[inline]
    fn has_direction(&self) -> bool {
        self.way != Vec3::default()
    }

    #[inline]
    fn fine_ray(&self) -> FineRay {
        self.ray()
    }
}

impl Ray<Fx32> for FineRay {
    type Fraction = Fine;
    type Share = Fine;

    #[inline]
    fn distance(&self) -> Gain32 {
        Gain32::normalised(self.length().into(), 47 - self.bits)
    }

    #[inline]
    fn direction(&self) -> Vec3<Fx32> {
        self.unit()
    }

    #[inline(always)]
    fn rise(&self, axis: Vec3<Fx32>, ramp: FixedRamp) -> Fine {
        ramp.rise_finely(self.versine(axis, ramp))
    }

    /// The cosine is capped at 1, also for normals longer than 1.
    #[inline]
    fn cosine(&self, _: i32, normal: Vec3<Fx32>) -> Fine {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Between opposite corners of the coordinate range, even half the difference does not fit 32
    /// bits.
    #[test]
    fn the_longest_offset_keeps_its_direction() {
        let corner = |bits| Vec3::new(bits, bits, bits).map(Length::from_bits);
        let offset = Offset32::between(corner(i32::MIN), corner(i32::MAX));
        assert_eq!((offset.way, offset.bits), (Vec3::new(i32::MAX, i32::MAX, i32::MAX), 32));
        let offset = Offset32::between(corner(i32::MAX), corner(i32::MIN));
        assert!(
            offset.way.x < -(1 << 30) && offset.bits == 32,
            "{offset:?}, expected offset.way.x < -(1 << 30) and offset.bits == 32"
        );
    }
}
