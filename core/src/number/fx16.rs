//! The 16-bit format, from a point to its light, in the order of the data.
//!
//! Scalars have 16 bits; lengths and directions have 32 bits; products have at most 32 bits, as on a
//! processor whose only multiplication has a 32-bit result. In the formulas `v` is the offset from
//! the light to the point, scaled until its largest component has 15 bits, and `|v|` is its length.
//!
//! | stage | function | result, with its fraction bits | error |
//! |---|---|---|---|
//! | offset | [`Offset::between`] | `way`, of 17 bits; `v`, of 15 | truncated, see direction |
//! | early-outs | [`facing`], [`is_outside`] | a sign; a comparison of squares | a margin: no lit point is rejected |
//! | root | [`root::inverse_sqrt_16`] | `2^30 / \|v\|`, of 15 or 16 bits | 9.0e-5, relative |
//! | direction | [`Offset::ray`] | unit vector, 30 | 1.1 times 1.55e-5 radians; its length 1.9e-4 |
//! | versine | [`versine`] | `\|l - s\|^2 / 2`, 29 and two for each step of the ramp's zoom | 2.9e-4 of the outer versine |
//! | ramp | [`FixedRamp::rise`] | `t`, 15 | 4e-5 |
//! | falloff | [`Fraction16`]: [`times_to_value`](Fraction::times_to_value) is the soft edge | intensity, 14 | soft, hard and linear 0.5 steps, smooth 1.3 |
//! | cosine | [`Ray::cosine`] | Lambert's cosine, 15 | 2.8 steps of 2^-14 |
//! | share | [`Fraction::times_value`] | cosine times falloff, 14 | 0.5 steps |
//! | attenuation | [`Gain16`] | a mantissa, mostly of 16 bits, and a shift | 1.7e-5, relative, for a product |
//! | light | [`Ray::light`] | share times gain over `\|v\|^2`, 14 | 3.1e-4, relative |
//!
//! The errors are those that `fx16/tests.rs`, `root.rs`, `ramp.rs` and, over all stages,
//! `tests/suite/operations.rs` test. `Errors::coarse_error` adds them to the bound of a cone. A
//! cone or a light that would magnify them beyond half a linear code has the *fine* evaluation, whose
//! stages are those of [`Fx32`](super::fx32) with the conversions below. The *quick* evaluation
//! replaces the stages from the offset to the versine by cheaper ones. On processors with vector instructions
//! `vectors.rs` takes the same stages for many points at once.
//!
//! # What may be changed
//!
//! Any stage, as long as its error holds. Then the bits differ: `cargo xtask conform --bless` records
//! the new ones, and `cargo xtask measure` counts the instructions. A change that keeps the bits needs
//! only the count: what the compiler makes of the code is part of the design, and the comments beside
//! `inline(always)` have the cost without it. `export/c/luminaire.h` repeats the stages for
//! lights that are exported as C, in the same order and with the same bits.

pub(super) mod errors;
mod frame;
mod set_up;
#[cfg(test)]
mod tests;
mod vectors;

pub use self::frame::Frame16;
use super::{
    Directed, Fraction, Fx16, Fx32, Gain, InversePower, Knot, Length, Light16, Offset, OffsetAlong, Quick,
    Ray, RealExponent, Share, Stages, Versine, Weight16, cold_path,
    fx32::{Fine, FineRay, Ratio, from_first, inverse_sum_16},
    knot::{SLOPE_BITS, neighbours},
    mantissa_and_shift,
    ramp::{Chords, FixedRamp, MOST_ZOOM, is_outside},
    root::{self, high_half, high_product, size, squared_length},
    within_reach,
};
use crate::{
    distribution::{Corners, Distribution},
    vec3::Vec3,
};

// ---- Offset ----

/// Number of bits of an offset's component that are multiplied by the reciprocal length.
///
/// The product has 31 bits in all. The offset has more bits than the reciprocal length, because an
/// error of the offset turns the direction, while an error of the reciprocal length only changes
/// the direction's length.
const WAY_BITS: u32 = 17;

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

impl Offset16 {
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
    /// A light's coordinate is within `32,767 - 256` unless the light was moved farther, see
    /// [`Scalar::FARTHEST`](crate::Scalar::FARTHEST). So a difference that wraps still has more than
    /// 24 bits, and the size test of `between` detects the wrap.
    #[inline(always)] // `away.fx16` on Cortex-M0: +9 instructions without.
    fn far(light: Vec3<Length>, point: Vec3<Length>) -> Self {
        let way = point.zip(light, |p, l| (p.to_bits() >> 1) - (l.to_bits() >> 1));
        let Self { way, shift, bits } = Self::scaled(way, root::bit_length(size(way)) - WAY_BITS);
        Self { way, shift, bits: bits + 1 }
    }

    /// Returns the offset for a vector of any size.
    pub(super) fn new(way: Vec3<i32>) -> Self {
        let size = size(way);
        if size >> WAY_BITS == 0 {
            Self::near(way, size)
        } else {
            Self::scaled(way, root::bit_length(size) - WAY_BITS)
        }
    }

    /// Returns the offset scaled to a largest component of 17 bits, rounded down.
    #[inline]
    fn way(&self) -> Vec3<i32> {
        self.way.map(|c| c >> self.shift)
    }

    /// Returns `v`, the offset scaled to a largest component of 15 bits, rounded down.
    #[inline]
    fn coarse(&self) -> Vec3<i32> {
        self.way.map(|c| c >> (self.shift + WAY_BITS - COARSE_BITS))
    }

    /// Returns `|v|^2`. The square is computed on demand, because a surface that faces away does not
    /// need it.
    #[inline]
    fn squared(&self) -> u32 {
        squared_length(self.coarse())
    }

    /// Returns the ray from the squared length and the reciprocal length.
    #[inline]
    fn ray_with(&self, squared: u32, reciprocal: u32) -> Ray16 {
        let fourteen_bits = ((reciprocal + 2) >> 2) as i32;
        let direction = self.way().map(|c| c.wrapping_mul(fourteen_bits));
        Ray16 { direction, bits: self.bits, squared, reciprocal }
    }

    /// Converts a component of the offset to a length; saturates.
    ///
    /// The component `part` has 13 fraction bits more than a component of [`way`](Self::way).
    #[inline]
    fn length_of(&self, part: i32) -> Length {
        const BITS: u32 = WAY_BITS + 13;
        Length::from_bits(if self.bits <= BITS {
            part >> (BITS - self.bits)
        } else {
            part.saturating_mul(1 << (self.bits - BITS))
        })
    }
}

/// Returns the inner product `n.v` of a normal and `v`, with 14 fraction bits; negative if the
/// surface faces the light.
///
/// The product wraps for normals longer than 1.15, and for a row whose points are in no order: defined
/// behaviour.
#[inline(always)] // `lit-step` on Cortex-M0: +9 instructions without.
fn facing(v: Vec3<i32>, normal: Vec3<Fx16>) -> i32 {
    let products = normal.zip(v, |n, v| i32::from(n.to_bits()).wrapping_mul(v));
    products.x.wrapping_add(products.y).wrapping_add(products.z)
}

impl Offset<Fx16> for Offset16 {
    type Ray = Ray16;
    type Facing = i32;

    #[inline]
    fn between(light: Vec3<Length>, point: Vec3<Length>) -> Self {
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

    #[inline(always)]
    fn facing(&self, normal: Vec3<Fx16>) -> i32 {
        facing(self.coarse(), normal)
    }

    #[inline]
    fn faces_away(facing: i32) -> bool {
        facing >= 0
    }

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
    fn squared_distance(&self) -> Gain16 {
        Gain16::normalised(self.squared(), 62 - 2 * self.bits as i32)
    }

    /// Computes the reciprocal length, and the direction as the product with its upper 14 bits.
    #[inline]
    fn ray(&self) -> Ray16 {
        let squared = self.squared();
        self.ray_with(squared, root::inverse_sqrt_16(squared))
    }
}

// ---- Direction, versine, ramp and cosine ----

/// Unit direction and reciprocal distance.
#[derive(Clone, Copy, Debug)]
pub struct Ray16 {
    direction: Vec3<i32>,
    bits: u32,
    squared: u32,
    /// `2^30 / |v|`, of 15 or 16 bits.
    reciprocal: u32,
}

/// Rounding bias added to a direction for the truncated bits of the offset, which average half a
/// unit.
///
/// The ideal bias is half the reciprocal length, so between `2^12 / sqrt(3)` and 2^13. Of the constants in
/// this range, 6,144 had the smallest error (measured).
pub(super) const CUT_OFF: i32 = 6_144;

/// Returns the versine of the angle between a direction and an axis, in the scale of a ramp.
#[inline]
fn versine(direction: Vec3<Fx32>, axis: Vec3<Fx32>, ramp: FixedRamp) -> Versine {
    let shift = MOST_ZOOM - ramp.zoom + 1;
    // The rounding constant of the difference is subtracted from the axis, which happens once per
    // light. The difference of opposite directions may wrap, but the wrapped value is also far
    // outside every cone.
    let axis = axis.map(|c| c.to_bits().wrapping_sub(1 << (shift - 1)));
    let difference = direction.zip(axis, |d, s| d.to_bits().wrapping_sub(s) >> shift);
    if size(difference) >> 15 != 0 {
        return Versine::MAX;
    }
    let squares = difference.map(|c| (c * c) as u32);
    Versine::from_bits(squares.x + squares.y + squares.z)
}

impl FixedRamp {
    /// Returns the falloff's argument at a versine: exactly 1 within the hotspot, exactly 0 at and
    /// beyond the limit. For a ramp that is not a fine ramp.
    #[inline]
    pub(super) fn rise(self, versine: Versine) -> Fraction16 {
        self.within(versine).unwrap_or_else(|| self.end(versine))
    }

    /// Returns `t` at a versine between the ends of the ramp, and `None` at any other versine.
    #[inline]
    fn within(self, versine: Versine) -> Option<Fraction16> {
        let past = versine.to_bits().wrapping_sub(self.inner);
        (past < self.width).then(|| Fraction16((self.one - (past >> self.shift) * self.mantissa) >> 16))
    }

    /// Returns `t` at a versine at or beyond an end of the ramp: 1 or 0.
    #[inline]
    fn end(self, versine: Versine) -> Fraction16 {
        Fraction16(if versine.to_bits() < self.inner { Fraction16::ONE } else { 0 })
    }
}

impl Ray<Fx16> for Ray16 {
    type Fraction = Fraction16;
    type Share = Fx16;

    #[inline]
    fn direction(&self) -> Vec3<Fx32> {
        self.direction.map(|c| Fx32::from_bits(c.wrapping_add(CUT_OFF)))
    }

    #[inline]
    fn rise(&self, axis: Vec3<Fx32>, ramp: FixedRamp) -> Fraction16 {
        ramp.rise(versine(self.direction(), axis, ramp))
    }

    #[inline]
    fn cosine(&self, facing: i32, _: Vec3<Fx16>) -> Fraction16 {
        // The product is at most the length of the normal, in units of 2^-31. The product wraps if
        // the normal is longer than 2.
        let along = facing.min(0).unsigned_abs() >> 13;
        Fraction16((along.wrapping_mul(self.reciprocal) >> 16).min(Fraction16::ONE))
    }

    #[inline]
    fn distance(&self) -> Gain16 {
        distance(self.squared, self.reciprocal, self.bits)
    }

    #[inline]
    fn light(&self, share: Fx16, gain: Gain16) -> Light16 {
        light_at(self.reciprocal, self.bits, share, gain)
    }
}

// ---- Distribution ----

impl Directed<Fx16> for Ray16 {
    /// The components and the places have 15 fraction bits, so that products fit 32 bits. Vectors that are not of unit length
    /// wrap: the result is the intensity in some direction.
    #[inline]
    fn distributed(&self, frame: &[Vec3<Fx32>; 3], distribution: Distribution<'_>) -> Fx16 {
        const ONE: u32 = 1 << 15;
        const HALF: i32 = 1 << 14;
        let direction = self.direction.map(|c| c.wrapping_add(CUT_OFF + HALF) >> 15);
        let [a, b, c] = frame.map(|axis| {
            let products = direction.zip(axis, |d, s| d.wrapping_mul(s.to_bits().wrapping_add(HALF) >> 15));
            products.x.wrapping_add(products.y).wrapping_add(products.z)
        });
        let [x, y] = [a, b].map(i32::unsigned_abs);
        let rounded = |sum: u32| sum.wrapping_add(HALF as u32) >> 15;
        let reciprocal = inverse_sum_16(rounded(x.wrapping_add(y).wrapping_add(c.unsigned_abs())));
        let place = |size: u32| (rounded(size).wrapping_mul(reciprocal).wrapping_add(ONE) >> 16).min(ONE);
        let (x, y) = (place(x), place(y));
        let (x, y) = if c < 0 { (ONE - y, ONE - x) } else { (x, y) };
        let x = if distribution.folds_side() { x } else { from_first(a, x, ONE) };
        let y = if distribution.folds_front() { y } else { from_first(b, y, ONE) };
        let bits = 15 - distribution.fineness();
        let Corners { index: [i, j], samples } = distribution.corners([x >> bits, y >> bits]);
        let (u, v) = ((x - (i << bits)) as i32, (y - (j << bits)) as i32);
        let between =
            |from: i32, to: i32, share: i32| from + (((to - from) * share + (1 << (bits - 1))) >> bits);
        let [near, far] = samples.map(|[from, to]| between(from.into(), to.into(), u));
        Fraction16::of_sixteen_bits(between(near, far, v))
    }

    #[inline]
    fn whole(&self) -> Fx16 {
        if self.reciprocal > 0 { Fx16::ONE } else { Fx16::ZERO }
    }
}

// ---- Falloff ----

/// A fraction with 15 fraction bits, the argument `t` of a falloff; a product of two has 30.
///
/// The fraction is stored in 32 bits, because a 16-bit value would need a truncation after each
/// operation. With 16 fraction bits a product would not fit 32 bits.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub struct Fraction16(pub(super) u32);

impl Fraction16 {
    /// Number of fraction bits.
    const BITS: u32 = 15;
    const ONE: u32 = 1 << Self::BITS;
    /// Half a step of a scalar, in units of a product of two fractions.
    pub(super) const HALF: u32 = 1 << Self::BITS;

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
    fn times(self, other: Self) -> Self {
        Self((self.0 * other.0 + Self::HALF / 2) >> Self::BITS)
    }

    #[inline]
    fn times_to_value(self, other: Self) -> Fx16 {
        Fx16::from_bits(((self.0 * other.0 + Self::HALF) >> (Self::BITS + 1)) as _)
    }

    #[inline]
    fn times_value(self, value: Fx16) -> Fx16 {
        let value = u32::from(value.to_bits() as u16);
        let product = (self.0 * value + Self::HALF / 2) >> Self::BITS;
        // The mask shows the compiler that the value is not negative.
        Fx16::from_bits((product & (Self::ONE - 1)) as _)
    }

    #[inline]
    fn value(self) -> Fx16 {
        Fx16::from_bits(((self.0 + 1) >> 1) as i16)
    }

    fn real_power(self, exponent: RealExponent) -> Self {
        const MORE: u32 = 31 - Fraction16::BITS;
        Self(((exponent.of_bits(self.0 << MORE) + (1 << MORE >> 1)) >> MORE) as u32)
    }

    #[inline]
    fn step(self) -> Fx16 {
        if self.0 > 0 { Fx16::ONE } else { Fx16::ZERO }
    }

    #[inline]
    fn smooth(self) -> Fx16 {
        let square = self.times(self).0;
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
    fn soft_pair(self, share: Weight16, ratio: Gain16) -> Fx16 {
        // The mantissa is rounded down, so the product is rounded up. A ratio in range has a shift of 5 to 15.
        let (product, bits) = (self.complement().0 * ratio.factor(), ratio.scale() as u32 & 15);
        let narrow = Self(Self::ONE.saturating_sub((product + (1 << bits) - 1) >> bits));
        let (share, [narrow, wide]) = (share.to_bits(), [narrow, self].map(|t| t.times(t).0 as i32));
        let rest = (1_i32 << Weight16::FRACTION_BITS).wrapping_sub(share);
        let sum = narrow.wrapping_mul(share).wrapping_add(wide.wrapping_mul(rest));
        Self::capped((sum as u32) << 1)
    }

    #[inline]
    fn sample(self, samples: &[u16]) -> Fx16 {
        let last = (samples.len() as u32).saturating_sub(1);
        let place = self.complement().0.wrapping_mul(last);
        let (here, next) = neighbours(samples, (place >> Self::BITS) as usize);
        let (here, next) = (i32::from(here), i32::from(next));
        let share = (place & (Self::ONE - 1)) as i32;
        let value = (here << Self::BITS) + (next - here) * share;
        Self::of_sixteen_bits((value + (1 << 14)) >> 15)
    }

    /// The product of a line's slope and the distance from its start has too many bits to be added
    /// to the start value, so the product is rounded first.
    #[inline]
    fn sample_knots(self, knots: &[Knot]) -> Fx16 {
        let place = self.complement().0 << 1;
        let knot = Knot::at(knots, place);
        let beyond = place.wrapping_sub(knot.place.into()) as i32;
        let rise = knot.slope.wrapping_mul(beyond).wrapping_add(1 << (SLOPE_BITS - 1)) >> SLOPE_BITS;
        Self::of_sixteen_bits((i32::from(knot.value) + rise).clamp(0, 65_535))
    }
}

impl Share<Fx16> for Fx16 {
    #[inline]
    fn of_scalar(scalar: Self) -> Self {
        scalar
    }

    #[inline]
    fn scalar(self) -> Self {
        self
    }

    #[inline]
    fn is_one(self) -> bool {
        self == Self::ONE
    }

    #[inline]
    fn complement(self) -> Self {
        Self::ONE.saturating_sub(self)
    }

    #[inline]
    fn times(self, other: Self) -> Self {
        let [a, b] = [self, other].map(|scalar| u32::from(scalar.to_bits() as u16));
        let product = a.wrapping_mul(b).wrapping_add(1 << 13) >> 14;
        Self::from_bits(product.min(1 << 14) as i16)
    }

    /// The result is exact except for a single rounding at the end, so the function is monotone.
    #[inline]
    fn smooth(self) -> Self {
        let t = factor(self.min(Self::ONE));
        let (square, factor) = (t * t, (3 << 14) - 2 * t);
        let product = (square >> 14) * factor + (((square & ((1 << 14) - 1)) * factor) >> 14);
        Self::from_bits(((product + (1 << 13)) >> 14) as i16)
    }

    #[inline]
    fn light(self, gain: Gain16) -> Light16 {
        Light16::shifted(factor(self) * gain.factor(), gain.scale())
    }
}

/// Returns a scalar as an unsigned factor; a negative scalar becomes 0.
#[inline]
fn factor(scalar: Fx16) -> u32 {
    (scalar.to_bits().max(0) as u16).into()
}

// ---- Attenuation and light ----

/// A factor `mantissa / 2^shift` with a mantissa of 32 bits.
///
/// The coarse evaluation uses only the upper 16 bits of the mantissa, in 32-bit products.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Gain16 {
    mantissa: u32,
    shift: i32,
}

impl From<Gain16> for Ratio {
    #[inline]
    fn from(Gain16 { mantissa, shift }: Gain16) -> Self {
        Self::new(mantissa, shift)
    }
}

impl Gain16 {
    const ZERO: Self = Self { mantissa: 0, shift: 0 };
    pub(super) const ONE: Self = Self { mantissa: 1 << 31, shift: 31 };
    /// A gain over every one that a product of lengths needs.
    pub(crate) const HUGE: Self = Self { mantissa: 1 << 31, shift: -1024 };

    /// Restores a gain from a mantissa and a shift. A mantissa with too few bits is normalised.
    pub const fn from_bits([mantissa, shift]: [i32; 2]) -> Self {
        let up = if mantissa == 0 { 0 } else { mantissa.leading_zeros() };
        Self { mantissa: (mantissa as u32) << up, shift: within_reach(shift) + up as i32 }
    }

    /// Returns the mantissa and the shift.
    pub const fn to_bits(self) -> [i32; 2] {
        [self.mantissa as i32, self.shift]
    }

    /// Returns the nearest gain; a negative value or NaN becomes zero.
    pub(crate) fn nearest(value: f32) -> Self {
        let (mantissa, shift) = mantissa_and_shift(value);
        Self { mantissa: mantissa << 8, shift: shift + 8 }
    }

    /// Returns `bits / 2^shift`, rounded to a mantissa of 16 bits.
    #[inline]
    pub(crate) fn normalised(bits: u32, shift: i32) -> Self {
        if bits == 0 {
            return Self::ZERO;
        }
        let up = u32::BITS as i32 - root::bit_length(bits) as i32;
        let mantissa = bits << up;
        let rounded = (mantissa >> 16) + ((mantissa >> 15) & 1);
        // Rounding up can carry into bit 16.
        let carry = rounded >> 16;
        Self { mantissa: rounded << (16 - carry), shift: within_reach(shift + up - carry as i32) }
    }

    /// Returns the upper 16 bits of the mantissa: the gain is `factor / 2^scale`.
    #[inline]
    fn factor(self) -> u32 {
        self.mantissa >> 16
    }

    #[inline]
    fn scale(self) -> i32 {
        self.shift - 16
    }

    /// Returns the gain times `factor / 2^fraction_bits`, as light; saturates.
    #[inline]
    pub(crate) fn light_of(self, factor: u32, fraction_bits: i32) -> Light16 {
        let product = high_product(factor, self.factor());
        Light16::shifted(product, self.scale() + fraction_bits - 16 - Fx16::FRACTION_BITS as i32)
    }

    /// Returns the gain divided by `2^down`.
    #[inline]
    pub(crate) fn halved(self, down: i32) -> Self {
        Self { shift: self.shift + down, ..self }
    }

    /// Returns whether this gain is more than another one.
    #[inline]
    pub(crate) fn exceeds(self, other: Self) -> bool {
        self.mantissa != 0 && (self.shift, other.mantissa) < (other.shift, self.mantissa)
    }
}

impl Gain<Fx16> for Gain16 {
    #[inline]
    fn times(self, other: Self) -> Self {
        Self::normalised(self.factor() * other.factor(), self.scale() + other.scale())
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        /// Left shift of the factors, which leaves one bit free: the sum of two factors may carry.
        const UP: u32 = 15;
        if self.mantissa == 0 || other.mantissa == 0 {
            return if self.mantissa == 0 { other } else { self };
        }
        let (large, small) = if self.shift < other.shift { (self, other) } else { (other, self) };
        let apart = (small.shift - large.shift) as u32;
        let aligned = (small.factor() << UP).checked_shr(apart).unwrap_or(0);
        Self::normalised((large.factor() << UP) + aligned, large.scale() + UP as i32)
    }

    #[inline]
    fn inverse_capped(self) -> Self {
        if self.mantissa == 0 || self.scale() >= 16 {
            return Self::ONE;
        }
        Self::normalised(root::inverse_16(self.factor()), 31 - self.scale())
    }

    #[inline]
    fn scalar(self) -> Fx16 {
        if self.mantissa != 0 && self.scale() < 16 {
            return Fx16::ONE;
        }
        Fx16::from_bits(Light16::shifted(self.factor(), self.scale() - 14).to_bits() as i16)
    }

    #[inline]
    fn times_scalar(self, scalar: Fx16) -> Self {
        if scalar >= Fx16::ONE { self } else { self.times(Self::normalised(factor(scalar), 14)) }
    }

    fn inverse_power(self, power: InversePower) -> Self {
        let (bits, shift) = power.of(self.mantissa, 31 - self.shift);
        Self::normalised(bits, shift)
    }
}

/// Returns the distance of the squared length, the reciprocal length and the bits of an offset.
#[inline]
fn distance(squared: u32, reciprocal: u32, bits: u32) -> Gain16 {
    // The argument is `|v| 2^14`, of 29 or 30 bits.
    Gain16::normalised(high_product(squared, reciprocal), 45 - bits as i32)
}

/// Returns a share times a gain as light, attenuated by the inverse square of the distance.
#[inline]
fn light_at(reciprocal: u32, bits: u32, share: Fx16, gain: Gain16) -> Light16 {
    Light16::shifted(product_at(reciprocal, share, gain), gain.scale() + 2 * bits as i32 - 32)
}

/// Returns the product of a share, a gain and the squared reciprocal length, before its shift.
#[inline]
fn product_at(reciprocal: u32, share: Fx16, gain: Gain16) -> u32 {
    // `reciprocal`, `squared` and `mantissa` have at most 16, 16 and 18 bits, so every product fits
    // 32 bits.
    let squared = (reciprocal * reciprocal) >> 16;
    let mantissa = (gain.factor() * squared) >> 14;
    factor(share).wrapping_mul(mantissa)
}

impl Light16 {
    /// Returns the light with the bits `product / 2^shift`, rounded to nearest; saturates.
    #[inline]
    fn shifted(product: u32, shift: i32) -> Self {
        let but_one = shift.wrapping_sub(1) as u32;
        Self::from_bits(if but_one < u32::BITS {
            let doubled = product >> but_one;
            (doubled >> 1) + (doubled & 1)
        } else if shift > 0 || product == 0 {
            0
        } else if shift.unsigned_abs() <= product.leading_zeros() {
            product << shift.unsigned_abs()
        } else {
            u32::MAX
        })
    }
}

// ---- Fine evaluation: the stages of `Fx32` for a point of `Fx16` ----

impl Ray<Fx16> for FineRay {
    type Fraction = Fine;
    type Share = Fine;

    #[inline]
    fn direction(&self) -> Vec3<Fx32> {
        self.unit()
    }

    #[inline(always)] // `falloff-alone` on Cortex-M0: +21 instructions without.
    fn rise(&self, axis: Vec3<Fx32>, ramp: FixedRamp) -> Fine {
        ramp.rise_finely(self.versine(axis, ramp))
    }

    /// Computes the cosine from the normal, because `facing` has too few bits. The sum wraps for
    /// normals longer than 1, which is defined behaviour.
    #[inline]
    fn cosine(&self, _: i32, normal: Vec3<Fx16>) -> Fine {
        let products = self.direction.zip(normal, |d, n| {
            let n = i32::from(n.to_bits());
            (d >> 14).wrapping_mul(n).wrapping_add(((d & 0x3fff) * n) >> 14)
        });
        let along = products.x.wrapping_add(products.y).wrapping_add(products.z);
        Fine::capped(along.min(0).unsigned_abs(), -1)
    }

    #[inline]
    fn distance(&self) -> Gain16 {
        Gain16::normalised(self.length(), 47 - self.bits)
    }

    #[inline]
    fn range_share(&self, gain: Gain16) -> Fine {
        Fine::capped(high_half(self.length(), gain.mantissa), gain.shift - self.bits - 16)
    }

    #[inline]
    fn squared_range_share<O: Offset<Fx16>>(&self, _: &O, gain: Gain16) -> Fine {
        Fine::capped(high_half(self.squared, gain.mantissa), gain.shift - 2 * self.bits - 1)
    }

    #[inline]
    fn light(&self, share: Fine, gain: Gain16) -> Light16 {
        // `here`, the gain at this distance, has at least 26 bits. The product of `here` and the
        // share has at least 16 bits, unless the light is far below one linear code.
        let here = self.attenuated(gain.mantissa);
        Light16::shifted(high_half(share.0, here), gain.shift + 2 * self.bits - 49)
    }
}

impl Directed<Fx16> for FineRay {
    #[inline]
    fn distributed(&self, frame: &[Vec3<Fx32>; 3], distribution: Distribution<'_>) -> Fine {
        self.distributed(frame, distribution)
    }

    #[inline]
    fn whole(&self) -> Fine {
        self.whole()
    }
}

impl Share<Fx16> for Fine {
    #[inline]
    fn of_scalar(scalar: Fx16) -> Self {
        Self(u32::from(scalar.to_bits().clamp(0, 1 << 14) as u16) << 17)
    }

    #[inline]
    fn scalar(self) -> Fx16 {
        Fx16::from_bits(((self.0 + (1 << 16)) >> 17) as i16)
    }

    #[inline]
    fn is_one(self) -> bool {
        self == Self::ONE
    }

    #[inline]
    fn complement(self) -> Self {
        self.complement()
    }

    #[inline(always)] // `lit-smooth-range` on Cortex-M0: +22 instructions without.
    fn times(self, other: Self) -> Self {
        self.times(other)
    }

    #[inline]
    fn smooth(self) -> Self {
        self.smooth()
    }

    #[inline(always)] // `lit-hotspot` on Cortex-M0: +28 instructions without.
    fn light(self, gain: Gain16) -> Light16 {
        Light16::shifted(high_half(self.0, gain.mantissa), gain.shift - 15)
    }
}

// ---- Quick evaluation: 15 bits of the offset, 14 fraction bits of a direction in every cone ----

/// Number of lower bits that the quick evaluation drops from a component of a direction.
const QUICK_DROPPED: u32 = 16;

/// Rounding bias added to a direction of the quick evaluation for the truncated bits of `v`.
///
/// The bias is three eighths of the largest reciprocal length, as in the standard evaluation.
pub(super) const QUICK_CUT_OFF: i32 = 24_576;

/// All rounding constants of a component of the difference between a direction and an axis.
const QUICK_ROUNDING: i32 = QUICK_CUT_OFF + (1 << (QUICK_DROPPED - 1));

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
    /// Returns an offset whose largest component is less than half a unit, or 64 units and more.
    #[cold]
    #[inline(never)]
    fn near_or_far(light: Vec3<Length>, point: Vec3<Length>) -> Self {
        let offset = Offset16::between(light, point);
        Self { way: offset.coarse(), bits: offset.bits }
    }
}

/// Points that differ in x alone, and whose offsets from a light have the same bit length.
#[derive(Clone, Copy, Debug)]
pub struct Stretch16 {
    /// The light's coordinate.
    x: i32,
    /// The first component x of the offsets, and the number of those that follow, itself included.
    first: i32,
    length: u32,
    /// The other components, scaled as those of the offsets.
    y: i32,
    z: i32,
    /// Right shift that brings the largest component to the bits of the evaluation.
    shift: u32,
}

impl Stretch16 {
    /// Returns the stretch around a point, whose offset has this bit length. It is empty unless the
    /// offset is shifted right, and by as much as the common path does.
    fn new(light: Vec3<Length>, point: Vec3<Length>, bits: u32) -> Self {
        /// The bit length from which on an offset is not on the common path.
        const FAR: u32 = COARSE_BITS + 8;
        let Vec3 { x, y, z } = point.zip(light, |p, l| p.to_bits().wrapping_sub(l.to_bits()));
        let end = 1_i32 << (bits - 1).min(FAR);
        let (first, length) = match bits {
            ..=COARSE_BITS | FAR.. => (0, 0),
            // The other components have all bits, or x has them alone.
            _ if size(Vec3::new(0, y, z)) >= end as u32 => (-2 * end, 4 * end as u32),
            _ => (if x < 0 { -2 * end } else { end }, end as u32),
        };
        let shift = bits.saturating_sub(COARSE_BITS);
        Self { x: light.x.to_bits(), first, length, y: y >> shift, z: z >> shift, shift }
    }
}

impl OffsetAlong<Fx16> for QuickOffset16 {
    type Stretch = Stretch16;

    fn stretch(light: Vec3<Length>, point: Vec3<Length>) -> Stretch16 {
        Stretch16::new(light, point, Self::between(light, point).bits)
    }

    #[inline]
    fn is_in(stretch: &Stretch16, x: Length) -> bool {
        let x = x.to_bits().wrapping_sub(stretch.x);
        (x.wrapping_sub(stretch.first) as u32) < stretch.length
    }

    #[inline(always)]
    fn on_stretch(&Stretch16 { x: light, y, z, shift, .. }: &Stretch16, x: Length) -> Self {
        let x = x.to_bits().wrapping_sub(light);
        Self { way: Vec3::new(x >> shift, y, z), bits: shift + COARSE_BITS }
    }
}

impl Offset<Fx16> for QuickOffset16 {
    type Ray = QuickRay16;
    type Facing = i32;

    #[inline]
    fn between(light: Vec3<Length>, point: Vec3<Length>) -> Self {
        let way = point.zip(light, |p, l| p.to_bits().wrapping_sub(l.to_bits()));
        // As in the standard evaluation, a difference that wraps has more than 24 bits, so this
        // test detects the wrap.
        let above = size(way) >> COARSE_BITS;
        if above == 0 || above >= 128 {
            cold_path();
            return Self::near_or_far(light, point);
        }
        // The shift is at most 7; the mask shows this to the compiler.
        let shift = (root::ilog2_of_seven_bits(above) + 1) & 7;
        Self { way: way.map(|c| c >> shift), bits: shift + COARSE_BITS }
    }

    #[inline]
    fn facing(&self, normal: Vec3<Fx16>) -> i32 {
        facing(self.way, normal)
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
    fn direction(&self) -> Vec3<Fx32> {
        self.product().map(|c| Fx32::from_bits(c.wrapping_add(QUICK_CUT_OFF)))
    }

    /// `axis` is the result of [`Quick::quick_axis`]. Each component of the difference between
    /// direction and axis has at most 15 bits and a sign, so the sum of the squares fits 32 bits
    /// for opposite directions, too.
    #[inline]
    fn rise(&self, axis: Vec3<Fx32>, ramp: FixedRamp) -> Fraction16 {
        let difference = self.product().zip(axis, |d, s| d.wrapping_sub(s.to_bits()) >> QUICK_DROPPED);
        let squares = difference.map(|c| c.wrapping_mul(c) as u32);
        let squared = squares.x.wrapping_add(squares.y).wrapping_add(squares.z);
        ramp.rise(Versine::from_bits(squared))
    }

    /// The result is over 1 for a normal that is longer than 1, and at most 2.
    #[inline]
    fn cosine(&self, facing: i32, _: Vec3<Fx16>) -> Fraction16 {
        let along = facing.min(0).unsigned_abs() >> 13;
        Fraction16(along.wrapping_mul(self.reciprocal) >> 16)
    }

    #[inline]
    fn distance(&self) -> Gain16 {
        distance(self.squared, self.reciprocal, self.offset.bits)
    }

    #[inline]
    fn light(&self, share: Fx16, gain: Gain16) -> Light16 {
        light_at(self.reciprocal, self.offset.bits, share, gain)
    }
}

impl Quick for Fx16 {
    type QuickOffset = QuickOffset16;

    fn quick_stages(distance: f64) -> Stages {
        errors::quick(errors::bits_at(distance))
    }

    /// Applies to the axis, once per light, all rounding constants of the difference between
    /// direction and axis.
    fn quick_axis(axis: Vec3<Fx32>) -> Vec3<Fx32> {
        axis.map(|c| Fx32::from_bits(c.to_bits().wrapping_sub(QUICK_ROUNDING)))
    }

    #[inline]
    fn standard_axis(quick: Vec3<Fx32>) -> Vec3<Fx32> {
        quick.map(|c| Fx32::from_bits(c.to_bits().wrapping_add(QUICK_ROUNDING)))
    }

    fn quick_ramp(inner: f32, outer: f32, limit: f32) -> FixedRamp {
        FixedRamp::with_zoom(inner, outer, limit, 0)
    }

    fn quick_zoomed(from: FixedRamp, to: FixedRamp, part: Self) -> (FixedRamp, Self) {
        let (ramp, chords) = from.between(to, thirty_two_bits(part), 0);
        (ramp, outside_bound(chords))
    }
}

/// The margin of the bound for rejecting points outside a cone, of which `number::outside_bound`
/// states the reason, and one step for the rounding of the squared cosine.
const OUTSIDE: i16 = 16 + 1;

/// Returns the bound for rejecting points outside a cone with these chords.
pub(crate) fn outside_bound(chords: Chords) -> Fx16 {
    Fx16::from_bits((chords.squared_cosine() >> 16) as i16 - OUTSIDE)
}

/// Converts a scalar between 0 and 1 to a number with 32 fraction bits.
#[inline]
fn thirty_two_bits(part: Fx16) -> u32 {
    u32::from(part.to_bits() as u16) << 18
}
