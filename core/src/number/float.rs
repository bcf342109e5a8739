//! The format `f32`, from a point to its light, in the order of the data; bit-identical on every
//! machine.
//!
//! The format uses only `+ - * /`, a correctly rounded square root, and clamps by compare and
//! select.
//!
//! | stage | function | result | error |
//! |---|---|---|---|
//! | offset | [`Offset::between`] | the vector from the point back to the light, and its squared length | turns the direction by 2^-24 radians; none on a common grid |
//! | early-outs | [`Offset::facing`], [`Offset::is_outside`] | a sign; a comparison of squares | a margin: no lit point is rejected |
//! | root | [`trig::inverse_sqrt`] | reciprocal length | a rounded root and a division |
//! | direction | [`Offset::ray`] | unit vector back to the light | 0.46 times 1.12e-7 radians, offset included; its length 1.8e-7 |
//! | versine | [`FloatRay::twice_versine`] | `\|l - s\|^2` | 6.1e-7 of the outer versine |
//! | ramp | [`FloatRamp::rise`] | `t` | 4 roundings, relative |
//! | falloff, cosine | [`Fraction`], [`Ray::cosine`] | intensity; Lambert's cosine | cosine 2.2 steps |
//! | light | [`Ray::light`] | share times gain over the squared length | 3.7e-7, relative |
//!
//! The errors are those that `tests/suite/operations.rs` tests.

pub(super) mod errors;
mod frame;
mod set_up;

pub use self::frame::FloatFrame;
use super::{
    Directed, Fraction, Gain, InversePower, Knot, Offset, Ray, RealExponent, Share,
    knot::{SLOPE_BITS, neighbours},
};
use crate::{
    distribution::{Corners, Distribution},
    trig,
    vec3::Vec3,
};

/// Returns `x` if it is positive, else zero; NaN becomes zero.
#[inline]
pub(crate) const fn positive(x: f32) -> f32 {
    if x > 0.0 { x } else { 0.0 }
}

/// Clamps `x` to `[0, 1]`; NaN becomes zero.
#[inline]
pub(crate) fn clamp(x: f32) -> f32 {
    let x = positive(x);
    if x < 1.0 { x } else { 1.0 }
}

// ---- Offset ----

/// Vector from a point back to the light, and its squared length.
///
/// The vector points back to the light because Lambert's cosine needs that direction. So the
/// difference between direction and axis is computed as a sum.
#[derive(Clone, Copy, Debug)]
pub struct FloatOffset {
    back: Vec3<f32>,
    squared: f32,
}

/// Unit direction back to the light, the squared distance, and the reciprocal distance.
#[derive(Clone, Copy, Debug)]
pub struct FloatRay {
    back: Vec3<f32>,
    squared: f32,
    reciprocal: f32,
}

impl Offset<f32> for FloatOffset {
    type Ray = FloatRay;
    type Facing = f32;

    /// Returns the vector from a point back to the light.
    #[inline]
    fn between(light: Vec3<f32>, point: Vec3<f32>) -> Self {
        let back = light.zip(point, |l, p| l - p);
        Self { back, squared: back.dot(back) }
    }

    #[inline]
    fn facing(&self, normal: Vec3<f32>) -> f32 {
        self.back.dot(normal)
    }

    #[inline]
    fn faces_away(facing: f32) -> bool {
        !matches!(facing.partial_cmp(&0.0), Some(core::cmp::Ordering::Greater))
    }

    #[inline]
    fn is_outside(&self, axis: Vec3<f32>, bound: f32) -> bool {
        let along = self.back.dot(axis);
        along * along.abs() > -bound * self.squared
    }

    #[inline]
    fn is_center_outside(&self, axis: Vec3<f32>, bound: f32) -> bool {
        self.squared.is_normal() && self.is_outside(axis, bound)
    }

    #[inline]
    fn squared_distance(&self) -> f32 {
        self.squared
    }

    /// A point whose squared distance is less than any normal number counts as on the light: its
    /// direction is zero. If the squared distance overflows f32, the reciprocal is zero as well, so
    /// no light arrives.
    #[inline]
    fn ray(&self) -> FloatRay {
        let reciprocal = trig::inverse_sqrt(self.squared);
        FloatRay { back: self.back.map(|c| c * reciprocal), squared: self.squared, reciprocal }
    }
}

// ---- Direction, versine, ramp and cosine ----

impl FloatRay {
    /// Returns the squared difference of direction and axis, which is twice the versine.
    #[inline]
    fn twice_versine(&self, axis: Vec3<f32>) -> f32 {
        let difference = self.back.zip(axis, |b, s| b + s);
        difference.dot(difference)
    }
}

impl Ray<f32> for FloatRay {
    type Fraction = f32;
    type Share = f32;

    #[inline]
    fn direction(&self) -> Vec3<f32> {
        self.back.map(|c| -c)
    }

    #[inline]
    fn distance(&self) -> f32 {
        trig::sqrt(self.squared)
    }

    /// Doubles the versines of the ramp instead of halving the versine of every point. This takes
    /// one multiplication less per point, and the result is bit-identical.
    #[inline]
    fn rise(&self, axis: Vec3<f32>, ramp: FloatRamp) -> f32 {
        let FloatRamp { outer, limit, reciprocal, inner } = ramp;
        let doubled =
            FloatRamp { outer: 2.0 * outer, limit: 2.0 * limit, reciprocal: 0.5 * reciprocal, inner };
        doubled.rise(self.twice_versine(axis))
    }

    #[inline]
    fn cosine(&self, facing: f32, _: Vec3<f32>) -> f32 {
        clamp(facing * self.reciprocal)
    }

    /// Saturates the attenuated gain, where `Share::light` saturates the light. So the
    /// compiler sees that a product of clamped shares is not negative, and removes the test for a
    /// negative share.
    #[inline]
    fn light(&self, share: f32, gain: f32) -> f32 {
        let gain = gain * (self.reciprocal * self.reciprocal);
        let share = if share < 0.0 { 0.0 } else { share };
        share * if gain < BRIGHTEST { gain } else { BRIGHTEST }
    }
}

/// One division takes fewer instructions than the steps of Newton that the bits of an `f32` need.
impl Directed<f32> for FloatRay {
    #[inline]
    fn distributed(&self, frame: &[Vec3<f32>; 3], distribution: Distribution<'_>) -> f32 {
        let [a, b, c] = frame.map(|axis| -self.back.dot(axis));
        let reciprocal = 1.0 / (a.abs() + b.abs() + c.abs());
        let (x, y) = (a.abs() * reciprocal, b.abs() * reciprocal);
        let (x, y) = if c < 0.0 { (1.0 - y, 1.0 - x) } else { (x, y) };
        let cells = (1_u32 << distribution.fineness()) as f32;
        let place = |folds, component: f32, size: f32| {
            let size = cells * clamp(size);
            if folds {
                size
            } else if component < 0.0 {
                cells - size
            } else {
                cells + size
            }
        };
        let (x, y) = (place(distribution.folds_side(), a, x), place(distribution.folds_front(), b, y));
        let Corners { index: [i, j], samples } = distribution.corners([x as u32, y as u32]);
        let (u, v) = (x - i as f32, y - j as f32);
        let [near, far] = samples.map(|[from, to]| f32::from(from) + (f32::from(to) - f32::from(from)) * u);
        let value = clamp((near + (far - near) * v) * (1.0 / 65_535.0));
        // Neither a NaN nor a direction of length 0 has a reciprocal.
        if reciprocal < 2.0 { value } else { 0.0 }
    }

    #[inline]
    fn whole(&self) -> f32 {
        // The reciprocal of a distance of NaN is not over 0.
        if self.reciprocal > 0.0 { 1.0 } else { 0.0 }
    }
}

/// A ramp, the map from versines to the falloff's argument `t`.
///
/// The fields are the outer versine, the versine of the cutoff, the reciprocal of the span from inner
/// to outer versine, and the inner versine. No point reads the inner versine: only a zoom does,
/// because the reciprocal of a narrow hotspot or of a steep edge has lost it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FloatRamp {
    outer: f32,
    limit: f32,
    reciprocal: f32,
    inner: f32,
}

impl FloatRamp {
    /// Restores a ramp from its bits, in the order of the fields.
    ///
    /// Invalid values are replaced, so that every versine gives a `t` in `[0, 1]`.
    pub const fn from_bits([outer, limit, reciprocal, inner]: [u32; 4]) -> Self {
        let [outer, limit] = [f32::from_bits(outer), f32::from_bits(limit)];
        let reciprocal = positive(f32::from_bits(reciprocal));
        Self {
            outer,
            limit: if limit < outer { limit } else { outer },
            reciprocal,
            inner: positive(f32::from_bits(inner)),
        }
    }

    /// Returns the bits, in the order of the fields.
    pub const fn to_bits(self) -> [u32; 4] {
        let Self { outer, limit, reciprocal, inner } = self;
        [outer.to_bits(), limit.to_bits(), reciprocal.to_bits(), inner.to_bits()]
    }

    /// Compiles a ramp: see `Ramps::ramp`.
    ///
    /// The reciprocal of the span is increased until `span * reciprocal >= 1`, so that `t` is exact
    /// at both ends of the ramp.
    pub(super) fn new(inner: f32, outer: f32, limit: f32) -> Self {
        let span = if inner < outer { outer - inner } else { 0.0 };
        let mut reciprocal = 1.0 / span;
        while reciprocal.is_finite() && span * reciprocal < 1.0 {
            reciprocal = f32::from_bits(reciprocal.to_bits() + 1);
        }
        Self {
            outer,
            limit: if limit < outer { limit } else { outer },
            reciprocal: if reciprocal < f32::MAX { reciprocal } else { f32::MAX },
            inner: positive(inner),
        }
    }

    /// Returns the ramp between this ramp and another one.
    fn between(self, other: Self, part: f32) -> Self {
        let [inner, outer, limit] =
            [(self.inner, other.inner), (self.outer, other.outer), (self.limit, other.limit)]
                .map(|(from, to)| versine_between(from, to, part));
        Self::new(inner, outer, limit)
    }

    #[inline]
    pub(crate) fn rise(self, versine: f32) -> f32 {
        // A versine of NaN is not below the limit, so `t` is 0.
        let rise = if versine < self.limit { (self.outer - versine) * self.reciprocal } else { 0.0 };
        if rise < 1.0 { rise } else { 1.0 }
    }
}

// ---- Falloff ----

/// The argument of a falloff and its result are both an `f32`.
impl Fraction<f32> for f32 {
    type Value = Self;

    #[inline]
    fn complement(self) -> Self {
        1.0 - self
    }

    #[inline]
    fn times(self, other: Self) -> Self {
        self * other
    }

    #[inline]
    fn times_to_value(self, other: Self) -> Self {
        self * other
    }

    #[inline]
    fn value(self) -> Self {
        self
    }

    fn real_power(self, exponent: RealExponent) -> Self {
        exponent.of_f32(self) as f32 * (1.0 / 2_147_483_648.0)
    }

    #[inline]
    fn times_value(self, value: Self) -> Self {
        value * self
    }

    #[inline]
    fn step(self) -> Self {
        if self > 0.0 { 1.0 } else { 0.0 }
    }

    #[inline]
    fn smooth(self) -> Self {
        clamp(self * self * (3.0 - (self + self)))
    }

    #[inline]
    fn quadratic(self, g: Self) -> Self {
        clamp(self * (1.0 + (1.0 - self) * g))
    }

    #[inline]
    fn cubic(self, g: Self, h: Self) -> Self {
        clamp(self * (1.0 + (1.0 - self) * (g + h * self)))
    }

    #[inline]
    fn soft_pair(self, share: Self, ratio: Self) -> Self {
        let narrow = 1.0 - (1.0 - self) * ratio;
        let narrow = if narrow > 0.0 { narrow } else { 0.0 };
        clamp((1.0 - share) * (self * self) + share * (narrow * narrow))
    }

    #[inline(always)] // `table.f32` on Cortex-M0: +69 instructions without.
    fn sample(self, samples: &[u16]) -> Self {
        let place = (1.0 - self) * samples.len().saturating_sub(1) as f32;
        let index = place as usize;
        let (here, next) = neighbours(samples, index);
        let (here, next) = (f32::from(here), f32::from(next));
        clamp((here + (next - here) * (place - index as f32)) * (1.0 / 65_535.0))
    }

    #[inline]
    fn sample_knots(self, knots: &[Knot]) -> Self {
        const STEP: f32 = 1.0 / (1 << SLOPE_BITS) as f32;
        let place = (1.0 - self) * 65_536.0;
        let knot = Knot::at(knots, place as u32);
        let rise = (place - f32::from(knot.place)) * (knot.slope as f32 * STEP);
        clamp((f32::from(knot.value) + rise) * (1.0 / 65_535.0))
    }
}

impl Share<f32> for f32 {
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
        self == 1.0
    }

    #[inline]
    fn complement(self) -> Self {
        1.0 - self
    }

    #[inline]
    fn times(self, other: Self) -> Self {
        self * other
    }

    #[inline]
    fn smooth(self) -> Self {
        let t = clamp(self);
        t * t * (3.0 - 2.0 * t)
    }

    #[inline]
    fn light(self, gain: Self) -> Self {
        let light = positive(self * gain);
        if light < BRIGHTEST { light } else { BRIGHTEST }
    }
}

// ---- Attenuation and light ----

/// Value at which irradiance saturates.
///
/// This value is so far below the largest f32 that sums and quotients of irradiances stay finite in
/// practice.
pub(crate) const BRIGHTEST: f32 = 18_446_744_073_709_551_616.0; // 2^64

impl Gain<f32> for f32 {
    #[inline]
    fn times(self, other: Self) -> Self {
        self * other
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        self + other
    }

    #[inline]
    fn inverse_capped(self) -> Self {
        1.0 / if self > 1.0 { self } else { 1.0 }
    }

    #[inline]
    fn scalar(self) -> Self {
        clamp(self)
    }

    #[inline]
    fn times_scalar(self, scalar: Self) -> Self {
        self * clamp(scalar)
    }

    /// Less than 2^-95 counts as 0.
    #[inline]
    fn inverse_power(self, power: InversePower) -> Self {
        let bits = self.to_bits();
        let significand = if self < Self::MIN_POSITIVE { 0 } else { bits << 8 | 1 << 31 };
        let (n, shift) = power.of(significand, (bits >> 23) as i32 - 127);
        if shift > 126 { 0.0 } else { n as Self * Self::from_bits(((127 - shift) as u32) << 23) }
    }
}

// ---- Set-up, colours and lobes ----

/// Returns the versine between two versines: its root is linear in `part`.
///
/// The result is within the range of the two versines. `part` is clamped to `[0, 1]`.
pub(crate) fn versine_between(from: f32, to: f32, part: f32) -> f32 {
    let part = clamp(part);
    // A sum of two positive terms keeps the leading bits of a narrow cone.
    let chord = trig::sqrt(from) * (1.0 - part) + trig::sqrt(to) * part;
    let (least, most) = if from < to { (from, to) } else { (to, from) };
    (chord * chord).max(least).min(most)
}

/// Lengths use the kernel's square root: that of `std` if available, else that of `libm`,
/// `micromath` or this crate.
impl Vec3<f32> {
    /// Returns the length. It is computed as the square root of the
    /// squared length, and the squared length may underflow or overflow.
    #[inline]
    pub fn length(self) -> f32 {
        FloatOffset::between(Vec3::default(), self).ray().distance()
    }

    /// Returns the reciprocal of the length; zero if the squared length is not a normal number.
    #[inline]
    pub fn reciprocal_length(self) -> f32 {
        FloatOffset::between(Vec3::default(), self).ray().reciprocal
    }

    /// Returns the vector scaled to unit length; zero if its squared length is not a normal number.
    #[must_use]
    #[inline]
    pub fn unit(self) -> Self {
        FloatOffset::between(Vec3::default(), self).ray().direction()
    }
}
