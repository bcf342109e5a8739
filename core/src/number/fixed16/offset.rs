//! Offset from a light to a point in the 16-bit format, and its direction and length.
//!
//! In the comments `v` is the offset, scaled until its largest component has 15 bits, and `|v|` is
//! its length.

use super::{Fraction16, factor};
use crate::number::{
    Arithmetic, FixedRamp, FullOffset, Fx16, Fx32, Gain16, Length, Light16, Offset, Ray, cold_path,
    fine_ray::{FineRay, size},
    product::high_product,
    root,
};
use crate::vec3::Vec3;

/// Number of bits of an offset's component that are multiplied by the reciprocal length.
///
/// The product has 31 bits in all. The offset has more bits than the reciprocal length, because an
/// error of the offset turns the direction, while an error of the reciprocal length only changes
/// the direction's length.
const WAY_BITS: u32 = 17;

/// Rounding bias added to a direction for the truncated bits of the offset, which average half a
/// unit.
///
/// The ideal bias is half the reciprocal length, so between 2,365 and 8,192. Of the constants in
/// this range, 6,144 had the smallest error (measured).
const CUT_OFF: i32 = 6_144;

/// Number of bits of an offset's component in all computations except that of the direction.
const COARSE_BITS: u32 = 15;

/// Offset from a light to a point. The largest component has at least 17 bits unless the offset is
/// zero.
#[derive(Clone, Copy, Debug)]
pub struct Offset16 {
    way: Vec3<i32>,
    /// Right shift that brings the largest component to 17 bits.
    shift: u32,
    /// Bit length of the largest component before any scaling.
    bits: u32,
}

/// Unit direction and reciprocal distance.
#[derive(Clone, Copy, Debug)]
pub struct Ray16 {
    direction: Vec3<i32>,
    bits: u32,
    squared: u32,
    /// `2^30 / |v|`, of 15 or 16 bits.
    reciprocal: u32,
}

impl Offset16 {
    /// Returns the offset from a light to a point.
    #[inline]
    pub(super) fn between(light: Vec3<Length>, point: Vec3<Length>) -> Self {
        let way = point.zip(light, |p, l| p.to_bits().wrapping_sub(l.to_bits()));
        let size = size(way);
        if size >> 24 != 0 {
            cold_path();
            return Self::far(light, point);
        }
        if size >> WAY_BITS == 0 {
            cold_path();
            return Self::near(way, size);
        }
        Self::scaled(way, root::ilog2_of_seven_bits(size >> WAY_BITS) + 1)
    }

    /// Returns an offset whose largest component has `more + 17` bits.
    #[inline]
    fn scaled(way: Vec3<i32>, more: u32) -> Self {
        // `more` is at most 14; the mask shows this to the compiler.
        let shift = more & 15;
        Self { way, shift, bits: shift + WAY_BITS }
    }

    /// Returns an offset with this [`size`] of at most 17 bits, scaled up for a precise direction.
    #[inline]
    fn near(way: Vec3<i32>, size: u32) -> Self {
        let bits = root::bit_length(size);
        Self { way: way.map(|c| c << (31 - bits)), shift: 31 - WAY_BITS, bits }
    }

    /// Returns an offset of more than 24 bits, halved to fit 32 bits.
    ///
    /// A light's coordinate is within 32,511 unless the light was moved farther, see
    /// [`Scalar::FARTHEST`](crate::Scalar::FARTHEST). So a difference that wraps still has more than
    /// 24 bits, and the size test of `between` detects the wrap.
    #[inline(always)] // `away.fx16` on Cortex-M0: +9 instructions without.
    fn far(light: Vec3<Length>, point: Vec3<Length>) -> Self {
        let way = point.zip(light, |p, l| (p.to_bits() >> 1) - (l.to_bits() >> 1));
        let Self { way, shift, bits } = Self::scaled(way, root::bit_length(size(way)) - WAY_BITS);
        Self { way, shift, bits: bits + 1 }
    }

    /// Returns the offset for a vector of any size.
    pub(in crate::number) fn new(way: Vec3<i32>) -> Self {
        let size = size(way);
        if size >> WAY_BITS == 0 {
            Self::near(way, size)
        } else {
            Self::scaled(way, root::bit_length(size) - WAY_BITS)
        }
    }

    /// Returns the offset scaled to a largest component of 17 bits, rounded down.
    #[inline]
    pub(super) fn fine(&self) -> Vec3<i32> {
        self.way.map(|c| c >> self.shift)
    }

    /// Converts a component of the offset to a length; saturates.
    ///
    /// The component `part` has 13 fraction bits more than a component of [`fine`](Self::fine).
    #[inline]
    pub(super) fn length_of(&self, part: i32) -> Length {
        const BITS: u32 = WAY_BITS + 13;
        Length::from_bits(if self.bits <= BITS {
            part >> (BITS - self.bits)
        } else {
            part.saturating_mul(1 << (self.bits - BITS))
        })
    }

    /// Returns the offset scaled to a largest component of 31 bits, with all bits of the offset.
    #[inline]
    fn whole(&self) -> Vec3<i32> {
        self.way.map(|c| c << (31 - WAY_BITS - self.shift))
    }

    /// Returns `v`, the offset scaled to a largest component of 15 bits.
    #[inline]
    fn coarse(&self) -> Vec3<i32> {
        self.way.map(|c| c >> (self.shift + WAY_BITS - COARSE_BITS))
    }

    /// Returns `v`, and the bit length of its largest component before scaling.
    pub(super) fn scaled_to_15_bits(&self) -> (Vec3<i32>, u32) {
        (self.coarse(), self.bits)
    }

    /// Returns `|v|^2`. The square is computed on demand, because a surface that faces away does not
    /// need it.
    #[inline]
    fn squared(&self) -> u32 {
        squared_length(self.coarse())
    }
}

/// Returns `|v|^2`. The sum of the squares of three numbers with 15 bits and a sign fits 32 bits.
#[inline]
pub(in crate::number) fn squared_length(v: Vec3<i32>) -> u32 {
    let squares = v.map(|c| (c * c) as u32);
    squares.x.wrapping_add(squares.y).wrapping_add(squares.z)
}

/// Returns whether an offset `v` is certainly outside a cone with this axis. `bound` is the bound of
/// [`FullOffset::is_outside`], with 14 fraction bits.
#[inline]
pub(in crate::number) fn is_outside(v: Vec3<i32>, axis: Vec3<Fx32>, bound: i32) -> bool {
    let products = axis.zip(v, |s, v| (s.to_bits() >> 16) * v);
    let along = products.x.wrapping_add(products.y).wrapping_add(products.z) >> 14;
    // The axis has unit length, so 16 bits hold the component of `v` along the axis.
    let along = along.max(0) as u32;
    let bound = u32::from(bound.max(0) as u16);
    along.wrapping_mul(along) < (squared_length(v) >> 14).wrapping_mul(bound)
}

impl Offset<Fx16> for Offset16 {
    type Ray = Ray16;
    /// The inner product `n.v` of the normal and `v`, with 14 fraction bits; negative if the
    /// surface faces the light.
    ///
    /// The inner product wraps for normals longer than 1.15, which is defined behaviour.
    type Facing = i32;

    #[inline(always)] // `spot-step-lambert` on Cortex-M0: +9 instructions without.
    fn facing(&self, normal: Vec3<Fx16>) -> i32 {
        let products = normal.zip(self.coarse(), |n, v| i32::from(n.to_bits()) * v);
        products.x.wrapping_add(products.y).wrapping_add(products.z)
    }

    #[inline]
    fn faces_away(facing: i32) -> bool {
        facing >= 0
    }

    #[inline]
    fn squared_distance(&self) -> Gain16 {
        Gain16::normalised(self.squared(), 62 - 2 * self.bits as i32)
    }

    #[inline]
    fn ray(&self) -> Ray16 {
        let squared = self.squared();
        let reciprocal = root::inverse_sqrt_16(squared);
        let fourteen_bits = ((reciprocal + 2) >> 2) as i32;
        Ray16 {
            direction: self.fine().map(|c| c.wrapping_mul(fourteen_bits)),
            bits: self.bits,
            squared,
            reciprocal,
        }
    }
}

impl FullOffset<Fx16> for Offset16 {
    type FineRay = FineRay;

    #[inline]
    fn faces_far_away(facing: i32) -> bool {
        // For a unit normal, the truncated bits of the three components of `v` change `n.v` by less
        // than sqrt(3).
        facing >= 7 << 12
    }

    #[inline]
    fn is_outside(&self, axis: Vec3<Fx32>, bound: Fx16) -> bool {
        is_outside(self.coarse(), axis, bound.to_bits().into())
    }

    #[inline]
    fn has_direction(&self) -> bool {
        self.way != Vec3::default()
    }

    #[inline(always)] // `spot-soft` on Cortex-M0: +80 instructions without.
    fn fine_ray(&self) -> FineRay {
        FineRay::new(self.whole(), root::inverse_sqrt_16(self.squared()), self.bits)
    }

    /// Compares the offset with the length that `fine_below` encodes.
    ///
    /// The upper bits of `fine_below` are a bit length, and the lower 26 bits a squared length. An
    /// offset with more bits than this bit length is too long. Otherwise the squared length of the
    /// offset is shifted to the encoded scale and compared.
    #[inline]
    fn is_near(&self, fine_below: u32) -> bool {
        let fewer = (fine_below >> 26).wrapping_sub(self.bits);
        fewer as i32 >= 0
            && self.squared().checked_shr(2 * fewer + 4).unwrap_or(0) < fine_below & ((1 << 26) - 1)
    }
}

impl Ray<Fx16> for Ray16 {
    type Fraction = Fraction16;
    type Share = Fx16;

    #[inline]
    fn distance(&self) -> Gain16 {
        // The argument is `|v| 2^14`, of 29 or 30 bits.
        Gain16::normalised(high_product(self.squared, self.reciprocal), 45 - self.bits as i32)
    }

    #[inline]
    fn direction(&self) -> Vec3<Fx32> {
        self.direction.map(|c| Fx32::from_bits(c.wrapping_add(CUT_OFF)))
    }

    #[inline]
    fn rise(&self, axis: Vec3<Fx32>, ramp: FixedRamp) -> Fraction16 {
        ramp.rise_coarsely(Fx16::versine_between(self.direction(), axis, ramp))
    }

    #[inline]
    fn cosine(&self, facing: i32, _: Vec3<Fx16>) -> Fraction16 {
        // The product is at most the length of the normal, in units of 2^-31. The product wraps if
        // the normal is longer than 2.
        let along = facing.min(0).unsigned_abs() >> 13;
        Fraction16((along.wrapping_mul(self.reciprocal) >> 16).min(1 << 15))
    }

    #[inline]
    fn expose(&self, fraction: Fx16, gain: Gain16) -> Light16 {
        // `reciprocal`, `squared` and `mantissa` have at most 16, 16 and 18 bits, so every product
        // fits 32 bits.
        let squared = (self.reciprocal * self.reciprocal) >> 16;
        let mantissa = (gain.factor() * squared) >> 14;
        Light16::shifted(factor(fraction).wrapping_mul(mantissa), gain.scale() + 2 * self.bits as i32 - 32)
    }
}
