//! The format `f32`, bit-identical on every machine.
//!
//! The format uses only `+ - * /`, a correctly rounded square root, and clamps by compare and
//! select.

mod frame;
mod offset;
mod quick;

pub use self::frame::FloatFrame;
use self::offset::FloatOffset;
use super::{
    Arithmetic, Gain, Offset, ProjectedPoint, Ray, Rise, Scalar, Slopes, Word, fraction::FloatFraction,
    outside_bound, raised,
};
use crate::{trig, vec3::Vec3};

/// Value at which irradiance saturates.
///
/// This value is so far below the largest f32 that sums and quotients of irradiances stay finite in
/// practice.
const BRIGHTEST: f32 = 18_446_744_073_709_551_616.0; // 2^64

/// A ramp, the map from versines to the falloff's argument `t`. The fields are the outer versine,
/// the versine of the cutoff, and the reciprocal of the span from inner to outer versine.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FloatRamp {
    outer: f32,
    limit: f32,
    reciprocal: f32,
}

impl FloatRamp {
    /// Restores a ramp from its bits, in the order of the fields.
    ///
    /// Invalid values are replaced, so that every versine gives a `t` in `[0, 1]`.
    pub const fn from_bits([outer, limit, reciprocal]: [u32; 3]) -> Self {
        let [outer, limit] = [f32::from_bits(outer), f32::from_bits(limit)];
        let reciprocal = positive(f32::from_bits(reciprocal));
        Self { outer, limit: if limit < outer { limit } else { outer }, reciprocal }
    }

    /// Returns the bits, in the order of the fields.
    pub const fn to_bits(self) -> [u32; 3] {
        [self.outer.to_bits(), self.limit.to_bits(), self.reciprocal.to_bits()]
    }

    /// Returns the ramp between this ramp and another one.
    fn between(self, other: Self, part: f32) -> Self {
        let [inner, outer, limit] =
            [(self.inner(), other.inner()), (self.outer, other.outer), (self.limit, other.limit)]
                .map(|(from, to)| versine_between(from, to, part));
        f32::ramp(inner, outer, limit)
    }

    /// Returns the inner versine, within the rounding error of the outer versine.
    ///
    /// A hotspot of less than 1/1,000 of the outer angle counts as none: its versine would be a
    /// rounding error, of which the root is large.
    fn inner(self) -> f32 {
        let inner = self.outer - 1.0 / self.reciprocal;
        if inner > 1e-6 * self.outer { inner } else { 0.0 }
    }

    #[inline]
    fn rise(self, versine: f32) -> FloatFraction {
        // A versine of NaN is not below the limit, so `t` is 0.
        let rise = if versine < self.limit { (self.outer - versine) * self.reciprocal } else { 0.0 };
        FloatFraction(if rise < 1.0 { rise } else { 1.0 })
    }
}

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

impl Scalar for f32 {
    type Length = f32;
    type Unit = f32;
    type Irradiance = f32;

    const NAME: &'static str = "f32";
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const STEP: f32 = f32::EPSILON;
    const FARTHEST: f32 = f32::MAX;

    fn from_f32(value: f32) -> Self {
        if value.is_nan() { 0.0 } else { value }
    }

    fn to_f32(self) -> f32 {
        self
    }

    fn length(value: f32) -> f32 {
        value
    }

    #[inline]
    fn light_to_f32(light: f32) -> f32 {
        light
    }
}

impl Arithmetic for f32 {
    type Position = f32;
    type Direction = f32;
    type Received = f32;
    type Versine = f32;
    type Fraction = FloatFraction;
    type Fine = FloatFraction;
    type Weight = f32;
    type Ramp = FloatRamp;
    type Frame = FloatFrame;
    type Gain = f32;
    type Offset = FloatOffset;
    // Two roundings turn the direction. The rounding of the difference `point - light` turns the
    // direction by 2^-24 in the worst case: two components are just over a power of two. The
    // rounding of the product with the reciprocal length turns the direction by 1.72 * 2^-25 in the
    // worst case: all three components are over 1/2.
    const OUTSIDE_STEP: f32 = Self::STEP;
    const DIRECTION_ERROR: f32 = 1.12e-7;

    #[inline]
    fn part(steps: u32) -> Self {
        steps as f32 * (1.0 / 16_384.0)
    }

    fn axis(axis: Vec3<f32>) -> Vec3<f32> {
        axis
    }

    fn versine(_: FloatRamp, value: f32) -> f32 {
        value
    }

    fn weight(value: f32) -> f32 {
        if value.is_nan() { 0.0 } else { value.clamp(-4.0, 4.0) }
    }

    fn gain(value: f32) -> f32 {
        positive(value)
    }

    #[inline]
    fn times(self, other: Self) -> Self {
        self * other
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        self - other
    }

    #[inline]
    fn offset(light: Vec3<f32>, point: Vec3<f32>) -> FloatOffset {
        FloatOffset::between(light, point)
    }

    fn enclosing(a: Vec3<f32>, b: Vec3<f32>) -> (Vec3<f32>, f32) {
        let half = a.zip(b, |a, b| 0.5 * (b - a));
        let center = a.zip(half, |a, half| a + half);
        // Half a unit in the last place of each coordinate, and of the centre's.
        let size = center.dot(center) + half.dot(half);
        (center, trig::sqrt(half.dot(half)) + 4e-7 * trig::sqrt(size))
    }

    fn moved_back(tip: Vec3<f32>, axis: Vec3<f32>, bound: f32, radius: f32) -> Option<Vec3<f32>> {
        let squared_sine = 1.0 - bound - 18.0 * Self::STEP;
        let (size, inverse_sine) =
            (tip.x.abs() + tip.y.abs() + tip.z.abs(), trig::inverse_sqrt(squared_sine));
        let back = radius * inverse_sine;
        // More than the rounding errors of the moved tip, across the cone.
        let back = back + 4e-7 * (size + back) * inverse_sine;
        (bound > 0.0 && squared_sine > 0.0).then(|| tip.zip(axis, |tip, axis| tip - back * axis))
    }

    fn offset_along(direction: Vec3<f32>) -> FloatOffset {
        FloatOffset::between(Vec3::default(), direction)
    }

    /// The reciprocal of the span is increased until `span * reciprocal >= 1`, so that `t` is exact
    /// at both ends of the ramp.
    fn ramp(inner: f32, outer: f32, limit: f32) -> FloatRamp {
        let span = if inner < outer { outer - inner } else { 0.0 };
        let mut reciprocal = 1.0 / span;
        while reciprocal.is_finite() && span * reciprocal < 1.0 {
            reciprocal = f32::from_bits(reciprocal.to_bits() + 1);
        }
        FloatRamp {
            outer,
            limit: if limit < outer { limit } else { outer },
            reciprocal: if reciprocal < f32::MAX { reciprocal } else { f32::MAX },
        }
    }

    /// The relative error of the versine is at most 1.1e-6. The versines computed at set-up
    /// contribute 4e-7. The rest comes from the lengths of direction and axis, from the difference
    /// of direction and axis, and from the square of this difference.
    fn rounding(edge: &Slopes) -> f32 {
        edge.angle * 0.55e-6 + (edge.fraction * 1.5 + 1.5) * Self::STEP
    }

    fn zoomed(from: FloatRamp, to: FloatRamp, part: f32) -> (FloatRamp, f32) {
        let ramp = from.between(to, part);
        (ramp, outside_bound(ramp.limit))
    }

    #[inline]
    fn rise(ramp: FloatRamp, versine: f32) -> Rise<f32> {
        Rise::Coarse(ramp.rise(versine))
    }

    #[inline]
    fn smooth(self) -> Self {
        let t = clamp(self);
        t * t * (3.0 - 2.0 * t)
    }

    fn frame(vectors: [Vec3<f32>; 3], tangent: f32) -> FloatFrame {
        FloatFrame::new(vectors, tangent)
    }

    #[inline]
    fn place(frame: &FloatFrame, light: Vec3<f32>, point: Vec3<f32>) -> ProjectedPoint<Self> {
        frame.place(point.zip(light, |p, l| p - l))
    }

    #[inline]
    fn weighted_byte(sum: u32) -> Self {
        // `sum >> 8` has at most 24 bits, which `f32` represents exactly.
        let share = (sum >> 8) as i32 as f32 * (1.0 / 16_711_680.0);
        if share < 1.0 { share } else { 1.0 }
    }

    #[inline]
    fn versine_between(a: Vec3<f32>, b: Vec3<f32>, _: FloatRamp) -> f32 {
        let difference = a.zip(b, |a, b| a - b);
        0.5 * difference.dot(difference)
    }

    #[inline]
    fn power(versine: f32, exponent: u32) -> f32 {
        raised(1.0, positive(1.0 - versine), exponent, |a, b| a * b)
    }

    #[inline]
    fn normal_unit(normal: Vec3<f32>) -> Vec3<f32> {
        normal
    }

    #[inline]
    fn unit_normal(unit: Vec3<f32>) -> Vec3<f32> {
        unit
    }

    #[inline]
    fn unit_of_bytes(bytes: [i8; 3]) -> Vec3<f32> {
        bytes.map(f32::from).into()
    }

    #[inline]
    fn mirror(direction: Vec3<f32>, normal: Vec3<f32>) -> Vec3<f32> {
        let twice = 2.0 * direction.dot(normal);
        direction.zip(normal, |d, n| d - twice * n)
    }

    #[inline]
    fn direction_between(a: Vec3<f32>, b: Vec3<f32>) -> Vec3<f32> {
        Self::offset(a, b).ray().direction()
    }

    #[inline]
    fn incidence(direction: Vec3<f32>, normal: Vec3<f32>) -> f32 {
        positive(-direction.dot(normal))
    }

    #[inline]
    fn expose(self, gain: f32) -> f32 {
        let light = positive(self * gain);
        if light < BRIGHTEST { light } else { BRIGHTEST }
    }

    #[inline]
    fn filter(light: f32, color: f32) -> f32 {
        light * color
    }

    #[inline]
    fn add_light(a: f32, b: f32) -> f32 {
        a + b
    }

    #[inline]
    fn light_to_gain(light: f32) -> f32 {
        light
    }

    #[inline]
    fn amplify(light: f32, gain: f32) -> f32 {
        light.expose(gain)
    }

    #[inline]
    fn light_steps(light: f32) -> u32 {
        (light * 16_384.0) as u32
    }

    #[inline]
    fn clip(light: f32) -> f32 {
        clamp(light)
    }

    #[inline]
    fn word(self) -> Word {
        Word::Single(self)
    }
}

impl Gain<f32> for f32 {
    #[inline]
    fn by(self, other: Self) -> Self {
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
    fn fraction(self) -> Self {
        clamp(self)
    }

    #[inline]
    fn part(self, part: Self) -> Self {
        self * clamp(part)
    }
}
