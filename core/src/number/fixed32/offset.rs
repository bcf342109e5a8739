//! Offset from a light to a point in the 32-bit format, and its direction and length.
//!
//! In the comments `|v|` is the length of the scaled offset, whose largest component has 31 bits.

use super::{Ramp32, factor, square, wide};
use crate::number::{
    Arithmetic, FullOffset, Fx32, Gain32, Length, Light32, Offset, Ray, cold_path, fraction::Fraction32, root,
};
use crate::vec3::Vec3;

/// Offset from a light to a point, scaled until its largest component has 31 bits.
#[derive(Clone, Copy, Debug)]
pub struct Offset32 {
    pub(super) way: Vec3<i32>,
    /// Bit length of the largest component before scaling, at least 1.
    pub(super) bits: u32,
}

/// Unit direction and reciprocal distance.
#[derive(Clone, Copy, Debug)]
pub struct Ray32 {
    direction: Vec3<i32>,
    bits: u32,
    squared: u64,
    /// `2^62 / |v|`, of 31 to 33 bits.
    reciprocal: u64,
}

/// Returns the inner product of a vector and an offset. The result wraps if the vector is longer
/// than 1.15.
#[inline]
fn inner_product(vector: Vec3<Fx32>, way: Vec3<i32>) -> i64 {
    let products = vector.zip(way, |a, b| wide(a.to_bits(), b));
    products.x.wrapping_add(products.y).wrapping_add(products.z)
}

impl Offset32 {
    /// Returns the offset from a light to a point.
    #[inline]
    pub(super) fn between(light: Vec3<Length>, point: Vec3<Length>) -> Self {
        let [p, l] = [point, light].map(|place| place.map(Length::to_bits));
        let way = (p.x.checked_sub(l.x), p.y.checked_sub(l.y), p.z.checked_sub(l.z));
        if let (Some(x), Some(y), Some(z)) = way {
            return Self::new(Vec3::new(x, y, z));
        }
        cold_path();
        let half = |p, l| ((i64::from(p) - i64::from(l) + 1) >> 1).min(i32::MAX.into()) as i32;
        let Self { way, bits } = Self::new(p.zip(l, half));
        Self { way, bits: bits + 1 }
    }

    /// Returns the offset for a vector of any size.
    #[inline]
    pub(super) fn new(way: Vec3<i32>) -> Self {
        let magnitudes = way.map(|c| (c ^ (c >> 31)) as u32);
        let bits = root::bit_length(magnitudes.x | magnitudes.y | magnitudes.z);
        Self { way: way.map(|c| c << (31 - bits)), bits }
    }

    /// Returns `|v|^2`. The square is computed on demand, because a surface that faces away does
    /// not need it.
    #[inline]
    fn squared(&self) -> u64 {
        let squares = self.way.map(square);
        squares.x + squares.y + squares.z
    }
}

impl Offset<Fx32> for Offset32 {
    type Ray = Ray32;
    /// The inner product of the normal and the scaled offset, with 30 fraction bits and the sign
    /// reversed.
    ///
    /// The inner product wraps for normals longer than 1.15, which is defined behaviour.
    type Facing = i64;

    #[inline]
    fn facing(&self, normal: Vec3<Fx32>) -> i64 {
        inner_product(normal, self.way).wrapping_neg()
    }

    #[inline]
    fn faces_away(facing: i64) -> bool {
        facing <= 0
    }

    #[inline]
    fn squared_distance(&self) -> Gain32 {
        Gain32::normalised(self.squared(), 94 - 2 * self.bits as i32)
    }

    #[inline(always)] // `lit.fx32` on Cortex-M0: +170 instructions without.
    fn ray(&self) -> Ray32 {
        let squared = self.squared();
        let reciprocal = if squared >= 1 << 62 {
            root::inverse_sqrt_32(squared) >> 1
        } else if squared >= 1 << 60 {
            root::inverse_sqrt_32(squared << 2)
        } else {
            0
        };
        let direction = self.way.map(|c| {
            let product = i64::from(c) * reciprocal as i64;
            ((product + (1 << 31)) >> 32) as i32
        });
        Ray32 { direction, bits: self.bits, squared, reciprocal }
    }
}

impl FullOffset<Fx32> for Offset32 {
    type FineRay = Ray32;

    #[inline]
    fn is_outside(&self, axis: Vec3<Fx32>, bound: Fx32) -> bool {
        let along = inner_product(axis, self.way) >> 31;
        along.wrapping_mul(along.abs()) < (self.squared() >> 32) as i64 * i64::from(bound.to_bits())
    }

    #[inline]
    fn has_direction(&self) -> bool {
        self.way != Vec3::default()
    }

    #[inline]
    fn fine_ray(&self) -> Ray32 {
        self.ray()
    }
}

impl Ray<Fx32> for Ray32 {
    type Fraction = Fraction32;
    type Share = Fx32;
    type Ramp = Ramp32;

    #[inline]
    fn distance(&self) -> Gain32 {
        // The distance is `|v| 2^30`, of 61 or 62 bits.
        let distance = (self.squared >> 30) * (self.reciprocal >> 2);
        Gain32::normalised(distance, 77 - self.bits as i32)
    }

    #[inline]
    fn direction(&self) -> Vec3<Fx32> {
        self.direction.map(Fx32::from_bits)
    }

    #[inline]
    fn rise(&self, axis: Vec3<Fx32>, ramp: Ramp32) -> Fraction32 {
        ramp.rise(Fx32::versine_between(self.direction(), axis, ramp))
    }

    #[inline]
    fn cosine(&self, facing: i64, _: Vec3<Fx32>) -> Fraction32 {
        // The product is at most the length of the normal, in units of 2^-61. The product fits 64
        // bits even if `facing` has wrapped: `facing` only wraps if `|v| > 2^31`, and then the
        // reciprocal is small.
        let cosine = ((facing.max(0) as u64 >> 31) * self.reciprocal) >> 30;
        Fraction32(cosine.min(1 << 31) as u32)
    }

    #[inline]
    fn expose(&self, share: Fx32, gain: Gain32) -> Light32 {
        // The reciprocal, the gain's factor and `mantissa` have at most 32, 28 and 34 bits, so
        // every product fits 64 bits.
        let reciprocal = self.reciprocal >> 1;
        let squared = (reciprocal * reciprocal) >> 28;
        let mantissa = (gain.factor() * squared) >> 28;
        Light32::shifted(factor(share) * mantissa, gain.scale() + 2 * self.bits as i32 - 28)
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
