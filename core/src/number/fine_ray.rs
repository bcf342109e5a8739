//! Direction to a point with 30 fraction bits, computed with 32-bit products.
//!
//! The fine evaluation of [`Fx16`](super::Fx16) and the evaluation of [`Fx32`] use this type of ray.
//!
//! In the comments `W` is the offset, scaled until its largest component has 31 bits, and `|W|` is
//! its length.

use super::{
    FixedRamp, Fx32, Versine,
    product::{high_half, high_product, high_square, signed_high_half, signed_high_product},
};
use crate::vec3::Vec3;

/// Unit direction with 30 fraction bits, and its distance.
#[derive(Clone, Copy, Debug)]
pub struct FineRay {
    pub(super) direction: Vec3<i32>,
    /// Bit length of the offset's largest component before scaling.
    pub(super) bits: i32,
    /// `|W|^2 / 2^32`.
    pub(super) squared: u32,
    /// Estimate of `2^46 / |W|`, before the correction by `excess`.
    estimate: u32,
    /// The relative excess of the estimate over `2^46 / |W|`, with 26 fraction bits.
    excess: i32,
}

/// Returns a number with the bit length of the largest component.
///
/// A negative component `c` counts as `-1 - c`.
#[inline]
pub(super) fn size(way: Vec3<i32>) -> u32 {
    let magnitudes = way.map(|c| (c ^ (c >> 31)) as u32);
    magnitudes.x | magnitudes.y | magnitudes.z
}

/// Returns `|2^shift vector|^2 / 2^32` of a vector with signed components.
#[inline]
pub(super) fn squared_length(vector: Vec3<i32>, shift: u32) -> u32 {
    let squares = vector.map(|c| high_square(c << shift));
    squares.x + squares.y + squares.z
}

/// Normalises a vector with 30 fraction bits whose length is within 3.5e-4 of 1.
///
/// The result has the direction of `nearly`, but for the rounding of each component down by less than
/// one unit of 2^-30, and a length with an error of at most 2.4e-8. Also returns the relative excess
/// of the length over 1, with 26 fraction bits.
#[inline(always)] // `spot-inverted-power-lambert` on Cortex-M0: +5 instructions without.
pub(super) fn normalised(nearly: Vec3<i32>) -> (Vec3<i32>, i32) {
    // The squared length of `nearly` is `1 + x`, and `1 / sqrt(1 + x) = 1 - x / 2 + 3/8 x^2`.
    let over = squared_length(nearly, 0).wrapping_sub(1 << 28) as i32;
    let coarse = over >> 4;
    let excess = (over >> 3) - ((3 * coarse.wrapping_mul(coarse)) >> 25);
    (nearly.map(|c| c - (signed_high_half(c, excess << 16) >> 10)), excess)
}

impl FineRay {
    /// Normalises an offset whose largest component has 31 bits, and had `bits` bits before
    /// scaling.
    ///
    /// `estimate` is `2^46 / |W|` with a relative error of at most 3.5e-4. The product with the
    /// estimate and the correction of the length are both rounded down, with opposite signs: so each
    /// component is within one unit of 2^-30 of its exact value times the length of the direction.
    /// The length has an error of at most 2.4e-8.
    #[inline(always)] // `spot-inverted-power-lambert` on Cortex-M0: +5 instructions without.
    pub(super) fn new(way: Vec3<i32>, estimate: u32, bits: u32) -> Self {
        let (direction, excess) = normalised(way.map(|c| signed_high_product(c, estimate)));
        Self { direction, bits: bits as i32, squared: squared_length(way, 0), estimate, excess }
    }

    /// Returns `2^61 / |W|`.
    #[inline]
    pub(super) fn reciprocal(&self) -> u32 {
        let less = (self.estimate as i32).wrapping_mul(self.excess) >> 11;
        (self.estimate << 15).wrapping_sub(less as u32)
    }

    /// Returns `gain 2^60 / |W|^2`.
    #[inline]
    pub(super) fn attenuated(&self, gain: u32) -> u32 {
        let nearly = high_product(high_product(gain, self.estimate), self.estimate);
        // `1 - (1 - e)^2` of the excess `e`.
        let excess = 2 * self.excess - (self.excess.wrapping_mul(self.excess) >> 26);
        let less = ((nearly >> 17) as i32).wrapping_mul(excess) >> 9;
        nearly.wrapping_sub(less as u32)
    }

    /// Returns `|W|`.
    #[inline]
    pub(super) fn length(&self) -> u32 {
        high_half(self.squared, self.reciprocal()) << 3
    }

    /// Returns the direction as a vector of `Fx32`.
    #[inline]
    pub(super) fn unit(&self) -> Vec3<Fx32> {
        self.direction.map(Fx32::from_bits)
    }

    /// Returns the versine of the angle between direction and axis, in the scale of a ramp.
    #[inline]
    pub(super) fn versine(&self, axis: Vec3<Fx32>, ramp: FixedRamp) -> Versine {
        versine(self.direction, axis, ramp)
    }
}

/// Returns the versine of the angle between a direction with 30 fraction bits and an axis, in the
/// scale of a ramp.
#[inline]
pub(super) fn versine(direction: Vec3<i32>, axis: Vec3<Fx32>, ramp: FixedRamp) -> Versine {
    let difference = direction.zip(axis, |d, s| d.wrapping_sub(s.to_bits()));
    // As in the coarse evaluation, a larger difference is outside the cone. The sum of the squares
    // of the accepted components has 30 bits inside the cone.
    if size(difference) >> (31 - ramp.zoom) != 0 {
        return Versine::MAX;
    }
    Versine::from_bits(squared_length(difference, ramp.zoom))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::fixed16::Offset16;
    use crate::number::{Arithmetic, FullOffset, Length, Offset};

    extern crate std;

    /// Tests the stated errors of the direction and of its length, over offsets of every size and
    /// direction. Three components that are off by one unit each turn the direction by at most
    /// `sqrt(3)` units.
    #[test]
    fn a_fine_direction_keeps_its_stated_error() {
        let (mut off, mut stretched) = (0.0_f64, 0.0_f64);
        // `ways` have components of any length. `dropped` have components of which the estimate
        // drops as much as possible.
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
            let wide = Fx32::offset(Vec3::default(), way.map(Length::from_bits)).ray();
            for ray in [Offset16::new(way).fine_ray(), wide] {
                let found = ray.direction.map(|c| f64::from(c) / f64::from(1 << 30));
                let squared = found.x * found.x + found.y * found.y + found.z * found.z;
                let error = found.zip(exact, |f, e| (f / squared.sqrt() - e / length).abs());
                off = off.max(error.x).max(error.y).max(error.z);
                stretched = stretched.max((squared.sqrt() - 1.0).abs());
            }
        }
        assert!(off * f64::from(1 << 30) <= 3_f64.sqrt(), "a component is off by {off:.1e}");
        assert!(stretched <= 2.4e-8, "the length is off by {stretched:.1e}");
    }
}
