//! The 32-bit format, from a point to its light, in the order of the data.
//!
//! Scalars, lengths and directions have 32 bits. From a point to the light at the point, nearly all
//! products are the upper halves of products of two 32-bit numbers. A processor without an
//! instruction for an upper half computes it from products of 16-bit numbers, on a Cortex-M0 in less than half
//! of the instructions of a product of 64 bits. The other operations, such as those on colours,
//! have products of 64 bits. In the formulas `W` is the offset from the light to the point, scaled
//! until its largest component has 31 bits, and `|W|` is its length.
//!
//! | stage | function | result, with its fraction bits | error |
//! |---|---|---|---|
//! | offset | [`Offset::between`] | `W`, of 31 bits | none, but for one bit beyond 32,768 units |
//! | early-outs | [`Offset::facing`], [`is_outside`] | of 15 bits of `W`: a sign; a comparison of squares | a margin: no lit point is rejected |
//! | root | [`root::quick_inverse_sqrt_16`] | estimate of `2^46 / \|W\|`, of 15 or 16 bits | 2.85e-4, relative, of 15 bits of `W` |
//! | direction | [`FineRay::new`], [`normalised`] | unit vector, 30: the product with the estimate, and one step of Newton | 1.1 times 2.68e-9 radians; its length 2.1e-8 |
//! | versine | [`versine`] | `\|l - s\|^2 / 2`, 29 and two for each step of the ramp's zoom | 3e-8 of the outer versine |
//! | ramp | [`FixedRamp::rise_finely`] | `t`, 31 | 1.7e-7 after a zoom, set-up included |
//! | falloff | [`Fine`]: [`times`](Fine::times) is the soft edge | intensity, 31 | a product 2^-30 |
//! | cosine | [`Ray::cosine`] | Lambert's cosine, 31 | 43 steps of 2^-30 |
//! | attenuation | [`Gain32`] | a mantissa of 28 bits and a shift | 4e-9, relative, for a product |
//! | light | [`Ray::light`] | share times gain over `\|W\|^2`, 30 | 6.2e-8, relative |
//!
//! The errors are those that `fx32/tests.rs`, `root.rs`, `ramp.rs` and, over all stages,
//! `tests/suite/operations.rs` test. The fine evaluation of [`Fx16`](super::fx16) has the same stages
//! from the direction to the falloff, with the root of its own offset.

pub(super) mod errors;
mod frame;
mod set_up;
#[cfg(test)]
mod tests;
mod vectors;

pub use self::frame::Frame32;
use super::{
    Directed, Fraction, Fx32, Gain, InversePower, Knot, Length, Light32, Offset, Ray, RealExponent, Share,
    Types, Versine, Weight16, Weight32, cold_path,
    knot::neighbours,
    mantissa_and_shift,
    ramp::{FixedRamp, is_outside},
    root::{
        self, high_half, high_product, high_square, signed_high_half, signed_high_product, size,
        squared_length,
    },
    within_reach,
};
use crate::{
    distribution::{Corners, Distribution},
    vec3::Vec3,
};

// ---- Offset ----

/// Number of lower bits of an offset that the square root and the early-outs do not use.
const DROPPED: u32 = 16;

/// Bit length up to which an offset is too short for the common path.
const SHORT: u32 = 16;

/// Offset from a light to a point, scaled until its largest component has 31 bits.
#[derive(Clone, Copy, Debug)]
pub struct Offset32 {
    way: Vec3<i32>,
    /// Bit length of the largest component before scaling, at least 1.
    bits: u32,
}

impl Offset32 {
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
    fn new(way: Vec3<i32>) -> Self {
        let bits = root::bit_length(size(way));
        Self { way: way.map(|c| c << (31 - bits)), bits }
    }

    /// Returns the upper 15 bits and the sign of each component.
    #[inline]
    fn coarse(&self) -> Vec3<i32> {
        self.way.map(|c| c >> DROPPED)
    }

    /// Converts a component of the scaled offset, with 60 fraction bits, to a length; saturates.
    #[inline]
    fn length_of(&self, part: i64) -> Length {
        let doubled = part >> (59 - self.bits);
        Length::from_bits(((doubled + 1) >> 1).min(i64::from(i32::MAX)) as i32)
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
    fn is_outside(&self, axis: Vec3<Fx32>, bound: Fx32) -> bool {
        is_outside(self.coarse(), axis, bound.to_bits() >> 16)
    }

    #[inline]
    fn squared_distance(&self) -> Gain32 {
        Gain32::normalised(sum_of_squares(self.way, 0).into(), 62 - 2 * self.bits as i32)
    }

    #[inline(always)]
    fn ray(&self) -> FineRay {
        FineRay::new(self.way, root::quick_inverse_sqrt_16(squared_length(self.coarse())), self.bits)
    }
}

// ---- Direction, versine, ramp and cosine ----

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

/// Returns `|2^shift vector|^2 / 2^32` of a vector with signed components.
#[inline]
fn sum_of_squares(vector: Vec3<i32>, shift: u32) -> u32 {
    let squares = vector.map(|c| high_square(c << shift));
    squares.x + squares.y + squares.z
}

/// Normalises a vector with 30 fraction bits whose length is within 2.85e-4 of 1.
///
/// The result has the direction of `nearly`, but for the rounding of each component down by less than
/// one unit of 2^-30, and a length with an error of at most 2.4e-8. Also returns the relative excess
/// of the length over 1, with 26 fraction bits.
#[inline(always)] // `lit-inverted-power` on Cortex-M0: +5 instructions without.
pub(crate) fn normalised(nearly: Vec3<i32>) -> (Vec3<i32>, i32) {
    // The squared length of `nearly` is `1 + x`, and `1 / sqrt(1 + x) = 1 - x / 2 + 3/8 x^2`.
    let over = sum_of_squares(nearly, 0).wrapping_sub(1 << 28) as i32;
    let coarse = over >> 4;
    let excess = (over >> 3) - ((3 * coarse.wrapping_mul(coarse)) >> 25);
    (nearly.map(|c| c - (signed_high_half(c, excess << 16) >> 10)), excess)
}

/// Returns the versine of the angle between a direction with 30 fraction bits and an axis, in the
/// scale of a ramp.
#[inline]
fn versine(direction: Vec3<i32>, axis: Vec3<Fx32>, ramp: FixedRamp) -> Versine {
    let difference = direction.zip(axis, |d, s| d.wrapping_sub(s.to_bits()));
    // As in the coarse evaluation, a larger difference is outside the cone. The sum of the squares
    // of the accepted components has 30 bits inside the cone.
    if size(difference) >> (31 - ramp.zoom) != 0 {
        return Versine::MAX;
    }
    Versine::from_bits(sum_of_squares(difference, ramp.zoom))
}

impl FineRay {
    /// Normalises an offset whose largest component has 31 bits, and had `bits` bits before
    /// scaling.
    ///
    /// `estimate` is `2^46 / |W|` with a relative error of at most 2.85e-4. The product with the
    /// estimate and the correction of the length are both rounded down, with opposite signs: so each
    /// component is within one unit of 2^-30 of its exact value times the length of the direction.
    /// The length has an error of at most 2.4e-8.
    #[inline(always)] // `lit-inverted-power` on Cortex-M0: +5 instructions without.
    pub(super) fn new(way: Vec3<i32>, estimate: u32, bits: u32) -> Self {
        let (direction, excess) = normalised(way.map(|c| signed_high_product(c, estimate)));
        Self { direction, bits: bits as i32, squared: sum_of_squares(way, 0), estimate, excess }
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

    /// Returns `|W|`, the product of `|W|^2` and `2^61 / |W|`.
    #[inline]
    pub(super) fn length(&self) -> u32 {
        let less = (self.estimate as i32).wrapping_mul(self.excess) >> 11;
        let reciprocal = (self.estimate << 15).wrapping_sub(less as u32);
        high_half(self.squared, reciprocal) << 3
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
}

impl Ray<Fx32> for FineRay {
    type Fraction = Fine;
    type Share = Fine;

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
    fn distance(&self) -> Gain32 {
        Gain32::normalised(self.length().into(), 47 - self.bits)
    }

    #[inline]
    fn light(&self, share: Fine, gain: Gain32) -> Light32 {
        let here = self.attenuated(gain.mantissa << 4);
        Light32::shifted_32(high_half(share.0, here), gain.shift + 2 * self.bits - 61)
    }
}

impl Directed<Fx32> for FineRay {
    #[inline]
    fn distributed(&self, frame: &[Vec3<Fx32>; 3], distribution: Distribution<'_>) -> Fine {
        self.distributed(frame, distribution)
    }

    #[inline]
    fn whole(&self) -> Fine {
        self.whole()
    }
}

// ---- Distribution ----

impl FineRay {
    /// Returns 1, and zero without a direction.
    #[inline]
    pub(super) fn whole(&self) -> Fine {
        if self.estimate > 0 { Fine::ONE } else { Fine(0) }
    }

    /// Returns the intensity of a distribution in the direction of the ray. For vectors that are not of unit length the
    /// result is that of some direction.
    pub(super) fn distributed(&self, frame: &[Vec3<Fx32>; 3], distribution: Distribution<'_>) -> Fine {
        // 28 fraction bits. The three products are rounded down by half a unit each in the mean.
        let [a, b, c] = frame.map(|axis| {
            let products = self.direction.zip(axis, |d, s| signed_high_half(d, s.to_bits()));
            products.x.wrapping_add(products.y).wrapping_add(products.z).wrapping_add(1)
        });
        let [x, y] = [a, b].map(i32::unsigned_abs);
        let sum = x.wrapping_add(y).wrapping_add(c.unsigned_abs());
        let reciprocal = inverse_sum_32(sum);
        let place = |size: u32| high_half(size << 3, reciprocal).min(1 << 30);
        let (x, y) = (place(x), place(y));
        let (x, y) = if c < 0 { ((1 << 30) - y, (1 << 30) - x) } else { (x, y) };
        let x = if distribution.folds_side() { x } else { from_first(a, x, 1 << 30) };
        let y = if distribution.folds_front() { y } else { from_first(b, y, 1 << 30) };
        let bits = 30 - distribution.fineness();
        let Corners { index: [i, j], samples } = distribution.corners([x >> bits, y >> bits]);
        // The shares have 31 fraction bits.
        let share = |place: u32, index: u32| (place - (index << bits)) << (31 - bits);
        let (u, v) = (share(x, i), share(y, j));
        let [near, far] = samples.map(|[from, to]| {
            let (value, step) = (u32::from(from) << 15, high_product(u, from.abs_diff(to).into()));
            if to < from { value - step } else { value + step }
        });
        let step = high_half(v, near.abs_diff(far) << 1);
        Fine::of_value(if far < near { near - step } else { near + step })
    }
}

/// Returns a place from the first sample of a row or a column, of its magnitude and the sign of a component.
#[inline]
pub(super) fn from_first(component: i32, size: u32, one: u32) -> u32 {
    if component < 0 { one - size } else { one + size }
}

/// Returns `2^31 / s` for `s` from 1 to `sqrt(3)` with 28 fraction bits: within 4e-9 of its size. For any other `s` the result
/// is some number.
#[inline]
fn inverse_sum_32(sum: u32) -> u32 {
    let nearly = inverse_sum_16(sum.wrapping_add(1 << 12) >> 13) << 15;
    // `1 - s r` with 30 fraction bits, of at most 16 bits.
    let lack = (1_i32 << 30).wrapping_sub(high_half(sum << 3, nearly) as i32);
    nearly.wrapping_add_signed(((nearly >> 16) as i32).wrapping_mul(lack) >> 14)
}

/// Returns `2^16 / s` for `s` from 1 to `sqrt(3)` with 15 fraction bits: within 3.4e-5 of its size (exhaustive), also 3e-4
/// beyond both ends. For any other `s` of 17 bits the result is some number.
///
/// The quadratic has the least largest error `e` that one can have (Chebyshev), which a step of Newton squares. Half of
/// the largest `e^2` is added, so that the error is as large in both directions.
#[inline]
pub(super) fn inverse_sum_16(sum: u32) -> u32 {
    /// `2` with 31 fraction bits, which wraps, and 1.3e-5.
    const TWO: u32 = 27_924;
    let bend = sum.wrapping_mul(13_585) >> 15;
    let guess = 74_694_u32.wrapping_sub(sum.wrapping_mul(55_677_u32.wrapping_sub(bend)) >> 15);
    let rest = TWO.wrapping_sub(sum.wrapping_mul(guess) << 1).wrapping_add(1 << 14) >> 15;
    guess.wrapping_mul(rest).wrapping_add(1 << 14) >> 15
}

impl FixedRamp {
    /// Returns the falloff's argument at a versine: exactly 1 within the hotspot, exactly 0 at and
    /// beyond the limit.
    #[inline(always)] // `falloff-alone` on Cortex-M0: +21 instructions without.
    pub(super) fn rise_finely(self, versine: Versine) -> Fine {
        let versine = versine.to_bits();
        let past = versine.wrapping_sub(self.inner);
        if past >= self.width.max(self.fine) {
            return if versine < self.inner { Fine::ONE } else { Fine(0) };
        }
        Fine(Fine::ONE.0.saturating_sub(self.fallen(past)))
    }
}

// ---- Falloff ----

/// A number in `[0, 1]` with 31 fraction bits: the argument of a falloff, and its result.
///
/// Two evaluations use it: that of [`Fx32`], because 32-bit products need fewer instructions than
/// 64-bit products, and the fine evaluation of [`Fx16`](super::Fx16).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Default, Debug)]
pub struct Fine(pub(crate) u32);

impl Fine {
    pub(super) const ONE: Self = Self(1 << 31);

    /// Returns `1 - self`.
    #[inline]
    pub(super) fn complement(self) -> Self {
        Self(Self::ONE.0 - self.0)
    }

    /// Returns the product, at most 2^-30 below the exact product; exactly 1 if both factors are 1.
    #[inline]
    pub(super) fn times(self, other: Self) -> Self {
        Self(high_half(self.0, other.0) << 1)
    }

    /// Returns `t^2 (3 - 2t)` for this fraction `t`.
    #[inline(always)] // `lit-smooth` on Cortex-M0: +5 instructions without.
    pub(super) fn smooth(self) -> Self {
        let square = self.times(self);
        Self((square.0 + 2 * square.times(self.complement()).0).min(Self::ONE.0))
    }

    /// Returns the fraction with the bits `product / 2^shift`, capped at 1.
    #[inline]
    pub(super) fn capped(product: u32, shift: i32) -> Self {
        let capped = if shift >= 0 {
            product.checked_shr(shift.unsigned_abs()).unwrap_or(0)
        } else if shift.unsigned_abs() < product.leading_zeros() {
            product << shift.unsigned_abs()
        } else if product > 0 {
            Self::ONE.0
        } else {
            0
        };
        Self(capped.min(Self::ONE.0))
    }

    /// Converts a table sample, shifted left by 15 bits, to a fraction. The sample 65,535 means 1.
    ///
    /// The conversion multiplies by the first two terms of `2^16 / (2^16 - 1) = 1 + 2^-16 + ..`
    #[inline]
    fn of_value(value: u32) -> Self {
        Self((value + ((value + (1 << 15)) >> 16)).min(Self::ONE.0))
    }

    /// Returns `t (1 + u slope)` for this fraction `t`, `u = 1 - t` and a slope with 28 fraction
    /// bits. The result is clamped to `[0, 1]`, also for an invalid slope.
    #[inline]
    fn lifted(self, slope: i32) -> Self {
        // A valid slope is in `[-3, 3]`, so `t u slope` with 27 fraction bits fits 28 bits.
        let lift = high_half(self.times(self.complement()).0, slope.unsigned_abs());
        let lift = lift.min((1 << 28) - 1) << 4;
        let lifted = if slope < 0 { self.0.saturating_sub(lift) } else { self.0.saturating_add(lift) };
        Self(lifted.min(Self::ONE.0))
    }
}

/// A coefficient of a falloff with 28 fraction bits. The conversion from a coefficient of a format
/// wraps if the coefficient is out of range.
#[derive(Clone, Copy, Debug)]
pub struct Slope(i32);

impl From<Weight16> for Slope {
    #[inline]
    fn from(weight: Weight16) -> Self {
        Self(weight.to_bits().wrapping_shl(28 - Weight16::FRACTION_BITS))
    }
}

impl From<Weight32> for Slope {
    #[inline]
    fn from(weight: Weight32) -> Self {
        Self((weight.to_bits() >> (Weight32::FRACTION_BITS - 28)) as i32)
    }
}

/// A gain of at least 1 as `mantissa 2^(bits - 31)`.
#[derive(Clone, Copy, Debug)]
pub struct Ratio {
    mantissa: u32,
    bits: u32,
}

impl Ratio {
    /// Creates the ratio `mantissa / 2^shift`. One that is out of range wraps.
    #[inline]
    pub(super) fn new(mantissa: u32, shift: i32) -> Self {
        Self { mantissa, bits: 31_i32.wrapping_sub(shift) as u32 & 31 }
    }
}

impl From<Gain32> for Ratio {
    #[inline]
    fn from(Gain32 { mantissa, shift }: Gain32) -> Self {
        Self::new(mantissa << 4, shift.wrapping_add(4))
    }
}

impl<S: Types<Weight: Into<Slope>, Gain: Into<Ratio>>> Fraction<S> for Fine
where
    Self: Share<S>,
{
    type Value = Self;

    #[inline]
    fn complement(self) -> Self {
        self.complement()
    }

    #[inline]
    fn times(self, other: Self) -> Self {
        self.times(other)
    }

    #[inline]
    fn times_to_value(self, other: Self) -> Self {
        self.times(other)
    }

    #[inline(always)] // `lit-step` on Cortex-M0: +38 instructions without.
    fn times_value(self, value: Self) -> Self {
        self.times(value)
    }

    #[inline]
    fn value(self) -> Self {
        self
    }

    #[inline]
    fn real_power(self, exponent: RealExponent) -> Self {
        Self(exponent.of_bits(self.0) as u32)
    }

    #[inline]
    fn step(self) -> Self {
        if self.0 > 0 { Self::ONE } else { Self(0) }
    }

    #[inline(always)] // `lit-smooth` on Cortex-M0: +5 instructions without.
    fn smooth(self) -> Self {
        self.smooth()
    }

    #[inline]
    fn quadratic(self, g: S::Weight) -> Self {
        self.lifted(g.into().0)
    }

    #[inline]
    fn cubic(self, g: S::Weight, h: S::Weight) -> Self {
        let (Slope(g), Slope(h)) = (g.into(), h.into());
        let bend = (high_half(self.0, h.unsigned_abs()) as i32) << 1;
        let bend = if h < 0 { bend.wrapping_neg() } else { bend };
        self.lifted(g.wrapping_add(bend))
    }

    #[inline]
    fn soft_pair(self, share: S::Weight, ratio: S::Gain) -> Self {
        let (Slope(share), Ratio { mantissa, bits }) = (share.into(), ratio.into());
        // A `u` that is cut off here is over `2 / g`, where the narrow falloff has ended.
        let scaled = self.complement().0.min(u32::MAX >> bits) << bits;
        let narrow = Self(high_half(scaled, mantissa).min(1 << 30) << 1).complement();
        let share = Self((share.clamp(0, 1 << 28) as u32) << 3);
        Self(narrow.times(narrow).times(share).0 + self.times(self).times(share.complement()).0)
    }

    #[inline]
    fn sample(self, samples: &[u16]) -> Self {
        let last = (samples.len().min(1 << 16) as u32).saturating_sub(1);
        let place = self.complement().0;
        // The position among the samples is the product of `place` and `last`, with 31 fraction
        // bits.
        let (here, next) = neighbours(samples, (high_product(place, last) >> 15) as usize);
        let share = place.wrapping_mul(last) & (Self::ONE.0 - 1);
        let (value, step) = (u32::from(here) << 15, high_product(share, here.abs_diff(next).into()));
        Self::of_value(if next < here { value - step } else { value + step })
    }

    #[inline]
    fn sample_knots(self, knots: &[Knot]) -> Self {
        let place = self.complement().0;
        let knot = Knot::at(knots, place >> 15);
        let (beyond, slope) = (place - (u32::from(knot.place) << 15).min(place), knot.slope.unsigned_abs());
        // The product of `beyond` and `slope` has at most 46 bits for a valid line; its lower 15
        // bits are dropped.
        let rise = high_half(beyond, slope) << 17 | beyond.wrapping_mul(slope) >> 15;
        let value = u32::from(knot.value) << 15;
        let value = if knot.slope < 0 { value.saturating_sub(rise) } else { value.saturating_add(rise) };
        Self::of_value(value.min(65_535 << 15))
    }
}

impl Share<Fx32> for Fine {
    #[inline]
    fn of_scalar(scalar: Fx32) -> Self {
        Self((scalar.to_bits().clamp(0, 1 << 30) as u32) << 1)
    }

    #[inline]
    fn scalar(self) -> Fx32 {
        Fx32::from_bits(self.0.div_ceil(2) as i32)
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

    #[inline]
    fn light(self, gain: Gain32) -> Light32 {
        Light32::shifted_32(high_half(self.0, gain.mantissa << 4), gain.shift - 27)
    }
}

impl Share<Fx32> for Fx32 {
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
        let [a, b] = [self, other].map(|scalar| u64::from(scalar.to_bits() as u32));
        let product = a.wrapping_mul(b).wrapping_add(1 << 29) >> 30;
        Self::from_bits(product.min(1 << 30) as i32)
    }

    /// The result is exact except for a single rounding at the end, so the function is monotone.
    #[inline]
    fn smooth(self) -> Self {
        let t = factor(self);
        let (square, factor) = (t * t, (3 << 30) - 2 * t);
        let product = (square >> 30) * factor + (((square & ((1 << 30) - 1)) * factor) >> 30);
        Self::from_bits(((product + (1 << 29)) >> 30) as i32)
    }

    #[inline]
    fn light(self, gain: Gain32) -> Light32 {
        Light32::shifted(factor(self) * u64::from(gain.mantissa), gain.shift)
    }
}

/// Returns a scalar clamped to `[0, 1]`, as an unsigned factor.
#[inline]
fn factor(scalar: Fx32) -> u64 {
    u64::from(scalar.clamp(Fx32::ZERO, Fx32::ONE).to_bits() as u32)
}

// ---- Attenuation and light ----

/// A factor `mantissa / 2^shift` with a mantissa of 28 bits, in 64-bit products.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Gain32 {
    mantissa: u32,
    shift: i32,
}

impl Gain32 {
    const ZERO: Self = Self { mantissa: 0, shift: 0 };
    const ONE: Self = Self { mantissa: 1 << 27, shift: 27 };

    /// Restores a gain from a mantissa and a shift.
    ///
    /// A mantissa with too few bits is normalised. If a mantissa has too many bits, only the lower
    /// bits are used.
    pub const fn from_bits([mantissa, shift]: [i32; 2]) -> Self {
        let mantissa = mantissa as u32 & ((1 << 28) - 1);
        let up = if mantissa == 0 { 0 } else { mantissa.leading_zeros() - 4 };
        Self { mantissa: mantissa << up, shift: within_reach(shift) + up as i32 }
    }

    /// Returns the mantissa and the shift.
    pub const fn to_bits(self) -> [i32; 2] {
        [self.mantissa as i32, self.shift]
    }

    /// Returns the nearest gain; a negative value or NaN becomes zero.
    fn nearest(value: f32) -> Self {
        let (mantissa, shift) = mantissa_and_shift(value);
        Self { mantissa: mantissa << 4, shift: shift + 4 }
    }

    /// Returns `bits / 2^shift`, rounded to a mantissa of 28 bits.
    #[inline]
    fn normalised(bits: u64, shift: i32) -> Self {
        if bits == 0 {
            return Self::ZERO;
        }
        let excess = 36 - bits.leading_zeros() as i32;
        if excess <= 0 {
            return Self { mantissa: (bits << -excess) as u32, shift: within_reach(shift - excess) };
        }
        let rounded = (((bits >> (excess - 1)) + 1) >> 1) as u32;
        // Rounding up can carry into bit 28.
        let carry = rounded >> 28;
        Self { mantissa: rounded >> carry, shift: within_reach(shift - excess - carry as i32) }
    }
}

impl Gain<Fx32> for Gain32 {
    #[inline]
    fn times(self, other: Self) -> Self {
        Self::normalised(u64::from(self.mantissa) * u64::from(other.mantissa), self.shift + other.shift)
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        /// Left shift of the mantissas, which leaves one bit free: the sum of two may carry.
        const UP: u32 = 35;
        if self.mantissa == 0 || other.mantissa == 0 {
            return if self.mantissa == 0 { other } else { self };
        }
        let (large, small) = if self.shift < other.shift { (self, other) } else { (other, self) };
        let apart = (small.shift - large.shift) as u32;
        let aligned = (u64::from(small.mantissa) << UP).checked_shr(apart).unwrap_or(0);
        Self::normalised((u64::from(large.mantissa) << UP) + aligned, large.shift + UP as i32)
    }

    #[inline]
    fn inverse_capped(self) -> Self {
        if self.mantissa == 0 || self.shift >= 28 {
            return Self::ONE;
        }
        Self::normalised(root::inverse_28(self.mantissa).into(), 55 - self.shift)
    }

    #[inline]
    fn scalar(self) -> Fx32 {
        if self.mantissa != 0 && self.shift < 28 {
            return Fx32::ONE;
        }
        Fx32::from_bits(Light32::shifted(self.mantissa.into(), self.shift - 30).to_bits() as i32)
    }

    #[inline]
    fn times_scalar(self, scalar: Fx32) -> Self {
        if scalar >= Fx32::ONE { self } else { self.times(Self::normalised(factor(scalar), 30)) }
    }

    fn inverse_power(self, power: InversePower) -> Self {
        let (bits, shift) = power.of(self.mantissa << 4, 27 - self.shift);
        Self::normalised(bits.into(), shift)
    }
}

impl Light32 {
    /// Returns the light with the bits `product / 2^shift`, rounded to nearest; saturates.
    #[inline]
    fn shifted(product: u64, shift: i32) -> Self {
        let but_one = shift.wrapping_sub(1) as u32;
        Self::from_bits(if but_one < u64::BITS {
            let doubled = product >> but_one;
            (doubled >> 1) + (doubled & 1)
        } else if shift > 0 || product == 0 {
            0
        } else if shift.unsigned_abs() <= product.leading_zeros() {
            product << shift.unsigned_abs()
        } else {
            u64::MAX
        })
    }

    /// Returns the result of [`shifted`](Self::shifted), computed with shifts of 32-bit numbers.
    #[inline]
    fn shifted_32(product: u32, shift: i32) -> Self {
        let (but_one, up) = (shift.wrapping_sub(1) as u32, shift.wrapping_neg() as u32);
        if but_one < u32::BITS {
            let doubled = product >> but_one;
            Self::from_bits(((doubled >> 1) + (doubled & 1)).into())
        } else if up < u32::BITS {
            let high = (product >> 1) >> (u32::BITS - 1 - up);
            Self::from_bits(u64::from(high) << u32::BITS | u64::from(product << up))
        } else {
            cold_path();
            Self::shifted(product.into(), shift)
        }
    }
}
