//! What the kernel asks of `f32` beside the evaluation of a point: set-up and its error bounds, projections,
//! colours, and the directions of specular lobes.

use super::{FloatFrame, FloatOffset, FloatRamp, FloatRay, clamp, errors, positive};
use crate::{
    number::{
        Arithmetic, Directions, Errors, Irradiance, Lights, Offset, Places, Placing, Ramps, Ray, Rise,
        Scalar, Share, Slopes, Stages, Types, Vectors, Word, outside_bound, raised,
    },
    trig,
    vec3::Vec3,
};

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

impl Irradiance for f32 {
    type Scalar = f32;
}

impl Types for f32 {
    type Position = f32;
    type Direction = f32;
    type Received = f32;
    type Versine = f32;
    type Fraction = f32;
    type Fine = f32;
    type FineRay = FloatRay;
    type Weight = f32;
    type Ramp = FloatRamp;
    type Frame = FloatFrame;
    type Gain = f32;
    type Offset = FloatOffset;
}

impl Arithmetic for f32 {
    const SKIPS: bool = false;

    #[inline]
    fn from_steps(steps: i32) -> Self {
        steps as f32 * (1.0 / 16_384.0)
    }

    fn weight(value: f32) -> f32 {
        if value.is_nan() { 0.0 } else { value.clamp(-4.0, 4.0) }
    }

    fn gain(value: f32) -> f32 {
        positive(value)
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        self - other
    }

    #[inline]
    fn weighted_byte(sum: u32) -> Self {
        // `sum >> 8` has at most 24 bits, which `f32` represents exactly.
        let share = (sum >> 8) as i32 as f32 * (1.0 / 16_711_680.0);
        if share < 1.0 { share } else { 1.0 }
    }

    #[inline]
    fn of_linear(float: impl FnOnce() -> f32, _: impl FnOnce() -> u32) -> Self {
        float()
    }

    #[inline]
    fn word(self) -> Word {
        Word::Single(self)
    }
}

impl Directions for f32 {
    fn axis(axis: Vec3<f32>) -> Vec3<f32> {
        axis
    }

    fn offset_along(direction: Vec3<f32>) -> FloatOffset {
        FloatOffset::between(Vec3::default(), direction)
    }

    #[inline]
    fn has_direction(offset: &FloatOffset) -> bool {
        offset.squared.is_normal()
    }

    #[inline]
    fn fine_ray(offset: &FloatOffset) -> FloatRay {
        offset.ray()
    }

    #[inline]
    fn direction_between(a: Vec3<f32>, b: Vec3<f32>) -> Vec3<f32> {
        FloatOffset::between(a, b).ray().direction()
    }

    #[inline]
    fn cross(a: Vec3<f32>, b: Vec3<f32>) -> Vec3<f32> {
        a.cross(b)
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
    fn incidence(direction: Vec3<f32>, normal: Vec3<f32>) -> f32 {
        positive(-direction.dot(normal))
    }
}

impl Places for f32 {
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

    fn along_integers(way: [i32; 3]) -> Vec3<f32> {
        way.map(|c| c as f32 / (1 << 30) as f32).into()
    }

    #[inline]
    fn length_times(length: f32, count: i32) -> f32 {
        length * count as f32
    }

    fn frame(vectors: [Vec3<f32>; 3], tangent: f32) -> FloatFrame {
        FloatFrame::new(vectors, tangent)
    }

    #[inline]
    fn project(frame: &FloatFrame, light: Vec3<f32>, point: Vec3<f32>) -> ([i32; 2], f32) {
        frame.project(point.zip(light, |p, l| p - l))
    }
}

impl Ramps for f32 {
    fn ramp(inner: f32, outer: f32, limit: f32) -> FloatRamp {
        FloatRamp::new(inner, outer, limit)
    }

    fn zoomed(from: FloatRamp, to: FloatRamp, part: f32) -> (FloatRamp, f32) {
        let ramp = from.between(to, part);
        (ramp, outside_bound(ramp.limit))
    }

    fn versine(_: FloatRamp, value: f32) -> f32 {
        value
    }

    #[inline]
    fn rise(ramp: FloatRamp, versine: f32) -> Rise<f32> {
        Rise::Coarse(ramp.rise(versine))
    }
}

impl Errors for f32 {
    // Two roundings turn the direction. The rounding of the difference `point - light` turns the
    // direction by 2^-24 in the worst case: two components are just over a power of two. The
    // rounding of the product with the reciprocal length turns the direction by 1.72 * 2^-25 in the
    // worst case: all three components are over 1/2.
    const DIRECTION_ERROR: f32 = 1.12e-7;
    // With `u = 2^-24`: the root of a versine, the complement of the part, the product and the sum have one rounding of `u`
    // each, and the square one more, half of which is that of a chord: `4.5 u`. The versines themselves are stored.
    const CHORD_ERROR: f32 = 4.5 / 16_777_216.0;
    const CHORD_STEP: f32 = 0.0;
    const LOSES_HIDDEN: bool = false;
    const NEAREST: f64 = 1.1e-19;
    const OUTSIDE_STEP: f32 = Self::STEP;

    /// The relative error of the versine is at most twice 0.55e-6. The versines computed at set-up
    /// contribute 4e-7. The rest comes from the lengths of direction and axis, from the difference
    /// of direction and axis, and from the square of this difference.
    fn rounding(edge: &Slopes) -> f32 {
        edge.angle * 0.55e-6 + ((edge.fraction + edge.beside_axis) * 1.5 + 1.5) * Self::STEP
    }

    fn stages(_: f64) -> Stages {
        errors::STAGES
    }

    fn placing(_: bool) -> Placing {
        errors::PLACING
    }

    fn magnification(_: f32) -> f64 {
        1.0
    }
}

impl Vectors<f32> for FloatOffset {}

impl Lights for f32 {
    #[inline]
    fn filter(light: f32, color: f32) -> f32 {
        light * color
    }

    #[inline]
    fn light_from_f32(value: f32) -> f32 {
        if value > 0.0 { value } else { 0.0 }
    }

    #[inline]
    fn mean_light(a: f32, b: f32) -> f32 {
        0.5 * a + 0.5 * b
    }

    #[inline]
    fn light_to_gain(light: f32) -> f32 {
        light
    }

    #[inline]
    fn amplify(light: f32, gain: f32) -> f32 {
        light.light(gain)
    }

    #[inline]
    fn clip(light: f32) -> f32 {
        clamp(light)
    }

    #[inline]
    fn light_steps(light: f32) -> u32 {
        (light * 16_384.0) as u32
    }
}
