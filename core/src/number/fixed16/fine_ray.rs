//! Direction to a point with 30 bits, and what is computed from it with the same precision.
//!
//! In the comments `W` is the offset, scaled until its largest component has 31 bits, and `|W|` is
//! its length.

use super::{
    Ramp16,
    fine::Fine16,
    offset,
    product::{high_half, high_square, signed_high_product},
};
use crate::number::{Fx16, Fx32, Gain16, Light16, Offset, Ray, Versine16};
use crate::vec3::Vec3;

/// Unit direction with 30 fraction bits, and its distance.
#[derive(Clone, Copy, Debug)]
pub struct FineRay16 {
    direction: Vec3<i32>,
    /// Bit length of the offset's largest component before scaling.
    bits: i32,
    /// `|W|^2 / 2^32`.
    squared: u32,
    /// `2^61 / |W|`.
    reciprocal: u32,
}

/// Returns `|2^shift vector|^2 / 2^32` of a vector with signed components.
#[inline]
fn squared_length(vector: Vec3<i32>, shift: u32) -> u32 {
    let squares = vector.map(|c| high_square(c.unsigned_abs() << shift));
    squares.x + squares.y + squares.z
}

impl FineRay16 {
    /// Normalises an offset whose largest component has 31 bits, scaled from `bits` bits.
    ///
    /// `estimate` is `2^46 / |W|` with a relative error of at most 2.4e-4. The components of the
    /// direction are within 6 units, and its length is within 3e-8.
    #[inline(always)] // `spot-inverted-power-lambert` on Cortex-M0: +5 instructions without.
    pub(super) fn new(way: Vec3<i32>, estimate: u32, bits: u32) -> Self {
        let nearly = way.map(|c| signed_high_product(c, estimate));
        // The squared length is `1 + x`, and `1 / sqrt(1 + x) = 1 - x / 2 + 3/8 x^2`.
        let over = squared_length(nearly, 1).wrapping_sub(1 << 30) as i32;
        let coarse = over >> 4;
        let excess = ((over >> 1) - 3 * (coarse.wrapping_mul(coarse) >> 25)) >> 4;
        Self {
            direction: nearly.map(|c| c - ((c >> 14).wrapping_mul(excess) >> 12)),
            bits: bits as i32,
            squared: squared_length(way, 0),
            reciprocal: (estimate << 15).wrapping_add_signed(-((estimate as i32).wrapping_mul(excess) >> 11)),
        }
    }

    /// Returns `|W|`.
    #[inline]
    fn length(&self) -> u32 {
        high_half(self.squared, self.reciprocal) << 3
    }
}

impl Ray<Fx16> for FineRay16 {
    type Fraction = Fine16;
    type Share = Fine16;

    #[inline]
    fn distance(&self) -> Gain16 {
        Gain16::normalised(self.length(), 47 - self.bits)
    }

    #[inline]
    fn direction(&self) -> Vec3<Fx32> {
        self.direction.map(Fx32::from_bits)
    }

    #[inline]
    fn versine(&self, axis: Vec3<Fx32>, ramp: Ramp16) -> Versine16 {
        let difference = self.direction.zip(axis, |d, s| d.wrapping_sub(s.to_bits()));
        // As in the coarse evaluation: inside the cone the sum of the accepted squares has 30 bits.
        if offset::size(difference) >> (31 - ramp.zoom) != 0 {
            return Versine16::MAX;
        }
        Versine16::from_bits(squared_length(difference, ramp.zoom))
    }

    #[inline(always)] // `spot-soft` on Cortex-M0: +21 instructions without.
    fn rise(&self, axis: Vec3<Fx32>, ramp: Ramp16) -> Fine16 {
        ramp.rise_finely(self.versine(axis, ramp))
    }

    /// Computed from the normal, because `facing` has too few bits. Wraps for normals longer than
    /// 1, which is defined behaviour.
    #[inline]
    fn cosine(&self, _: i32, normal: Vec3<Fx16>) -> Fine16 {
        let products = self.direction.zip(normal, |d, n| {
            let n = i32::from(n.to_bits());
            (d >> 14).wrapping_mul(n).wrapping_add(((d & 0x3fff) * n) >> 14)
        });
        let along = products.x.wrapping_add(products.y).wrapping_add(products.z);
        Fine16::capped(along.min(0).unsigned_abs(), -1)
    }

    #[inline]
    fn near(&self, gain: Gain16) -> Fine16 {
        Fine16::capped(high_half(self.length(), gain.mantissa), gain.shift - self.bits - 16)
    }

    #[inline]
    fn squared_near<O: Offset<Fx16>>(&self, _: &O, gain: Gain16) -> Fine16 {
        Fine16::capped(high_half(self.squared, gain.mantissa), gain.shift - 2 * self.bits - 1)
    }

    #[inline]
    fn expose(&self, share: Fine16, gain: Gain16) -> Light16 {
        // `here`, the gain at this distance, has at least 26 bits. The product of `here` and the
        // share has at least 16 bits, unless the light is far below one linear code.
        let here = high_half(high_square(self.reciprocal), gain.mantissa);
        Light16::shifted(high_half(share.0, here), gain.shift + 2 * self.bits - 51)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::FullOffset;
    use crate::number::fixed16::offset::Offset16;

    extern crate std;

    /// The stated errors of the direction and of its length, over offsets of every size and direction.
    #[test]
    fn a_fine_direction_keeps_its_stated_error() {
        let (mut off, mut stretched) = (0.0_f64, 0.0_f64);
        // Components of any length, and such that the estimate drops as much of them as it can.
        let ways = (0..200_000_u32).map(|i| {
            let part = |factor: u32| i.wrapping_add(1).wrapping_mul(factor) as i32 >> (1 + i % 12);
            Vec3::new(part(0x9e37_79b9), part(0x85eb_ca6b), part(0xc2b2_ae35))
        });
        let dropped = (0..200_000_u32).map(|i| {
            let part = |factor: u32| (((1 << 14) + (i.wrapping_mul(factor) >> 18)) << 16) as i32 - 1;
            Vec3::new(part(0x9e37_79b9), part(0x85eb_ca6b), part(0xc2b2_ae35))
                .map(|c| if i % 2 == 0 { c } else { 1 - c })
        });
        for way in ways.chain(dropped) {
            let exact = way.map(f64::from);
            let length = (exact.x * exact.x + exact.y * exact.y + exact.z * exact.z).sqrt();
            let found = Offset16::new(way).fine_ray().direction.map(|c| f64::from(c) / f64::from(1 << 30));
            let squared = found.x * found.x + found.y * found.y + found.z * found.z;
            let error = found.zip(exact, |f, e| (f / squared.sqrt() - e / length).abs());
            off = off.max(error.x).max(error.y).max(error.z);
            stretched = stretched.max((squared.sqrt() - 1.0).abs());
        }
        assert!(off * f64::from(1 << 30) <= 6.0, "a component is off by {off:.1e}");
        assert!(stretched <= 3e-8, "the length is off by {stretched:.1e}");
    }

    /// A normal longer than 1 wraps, as the same product in 64 bits does when it is cut to 32.
    #[test]
    fn the_cosine_of_a_long_normal_wraps() {
        let ways =
            [Vec3::new(1 << 20, 1 << 20, 1 << 20), Vec3::new(-(1 << 20), 0, 0), Vec3::new(1 << 20, 0, 0)];
        let rays = ways.map(|way| Offset16::new(way).fine_ray());
        for (ray, n) in
            rays.into_iter().flat_map(|ray| [i16::MIN, -20_000, 1 << 14, 30_000, i16::MAX].map(|n| (ray, n)))
        {
            let product =
                |d: i32| (i64::from(d >> 14) * i64::from(n)) + ((i64::from(d & 0x3fff) * i64::from(n)) >> 14);
            let along =
                (product(ray.direction.x) + product(ray.direction.y) + product(ray.direction.z)) as i32;
            let normal = Vec3::new(n, n, n).map(Fx16::from_bits);
            assert_eq!(ray.cosine(0, normal), Fine16::capped(along.min(0).unsigned_abs(), -1), "{n}");
        }
    }
}
