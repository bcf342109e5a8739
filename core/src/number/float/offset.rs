//! Vector from a point to a light in f32, and its direction and length.

use super::{BRIGHTEST, FloatRamp, clamp};
use crate::number::{Arithmetic, FullOffset, Offset, Ray, fraction::FloatFraction};
use crate::{trig, vec3::Vec3};

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

impl FloatOffset {
    /// Returns the vector from a point back to the light.
    #[inline]
    pub(super) fn between(light: Vec3<f32>, point: Vec3<f32>) -> Self {
        let back = light.zip(point, |l, p| l - p);
        Self { back, squared: back.dot(back) }
    }
}

impl Offset<f32> for FloatOffset {
    type Ray = FloatRay;
    type Facing = f32;

    #[inline]
    fn facing(&self, normal: Vec3<f32>) -> f32 {
        self.back.dot(normal)
    }

    #[inline]
    fn faces_away(facing: f32) -> bool {
        !matches!(facing.partial_cmp(&0.0), Some(core::cmp::Ordering::Greater))
    }

    #[inline]
    fn squared_distance(&self) -> f32 {
        self.squared
    }

    #[inline]
    fn ray(&self) -> FloatRay {
        self.ray_of(self.reciprocal())
    }
}

impl FullOffset<f32> for FloatOffset {
    type FineRay = FloatRay;
    const ROOTS_FIRST: bool = true;

    #[inline]
    fn is_outside(&self, axis: Vec3<f32>, bound: f32) -> bool {
        let along = self.back.dot(axis);
        along * along.abs() > -bound * self.squared
    }

    #[inline]
    fn has_direction(&self) -> bool {
        self.squared.is_normal()
    }

    #[inline]
    fn fine_ray(&self) -> FloatRay {
        self.ray()
    }

    /// A point whose squared distance is less than any normal number counts as on the light: its
    /// direction is zero. If the squared distance overflows f32, the reciprocal is zero as well, so
    /// no light arrives.
    #[inline]
    fn reciprocal(&self) -> f32 {
        trig::inverse_sqrt(self.squared)
    }

    #[inline]
    fn ray_of(&self, reciprocal: f32) -> FloatRay {
        FloatRay { back: self.back.map(|c| c * reciprocal), squared: self.squared, reciprocal }
    }
}

/// Lengths use the kernel's square root: that of `std` if available, else that of `libm`,
/// `micromath` or this crate.
impl Vec3<f32> {
    /// Returns the length. It is computed as the square root of the squared length, and the squared length may underflow or overflow.
    #[inline]
    pub fn length(self) -> f32 {
        f32::offset(Vec3::default(), self).ray().distance()
    }

    /// Returns the reciprocal of the length; zero if the squared length is not a normal number.
    #[inline]
    pub fn reciprocal_length(self) -> f32 {
        f32::offset(Vec3::default(), self).reciprocal()
    }

    /// Returns the vector scaled to unit length; zero if its squared length is not a normal number.
    #[inline]
    pub fn unit(self) -> Self {
        f32::offset(Vec3::default(), self).ray().direction()
    }
}

impl FloatRay {
    /// Returns the squared difference of direction and axis, which is twice the versine.
    #[inline]
    fn twice_versine(&self, axis: Vec3<f32>) -> f32 {
        let difference = self.back.zip(axis, |b, s| b + s);
        difference.dot(difference)
    }
}

impl Ray<f32> for FloatRay {
    type Fraction = FloatFraction;
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
    fn rise(&self, axis: Vec3<f32>, ramp: FloatRamp) -> FloatFraction {
        let doubled =
            FloatRamp { outer: 2.0 * ramp.outer, limit: 2.0 * ramp.limit, reciprocal: 0.5 * ramp.reciprocal };
        doubled.rise(self.twice_versine(axis))
    }

    #[inline]
    fn cosine(&self, facing: f32, _: Vec3<f32>) -> FloatFraction {
        FloatFraction(clamp(facing * self.reciprocal))
    }

    /// Saturates the attenuated gain, where `Arithmetic::expose` saturates the light. So the
    /// compiler sees that a product of clamped fractions is not negative, and removes the test for
    /// a negative fraction.
    #[inline]
    fn expose(&self, fraction: f32, gain: f32) -> f32 {
        let gain = gain * (self.reciprocal * self.reciprocal);
        let fraction = if fraction < 0.0 { 0.0 } else { fraction };
        fraction * if gain < BRIGHTEST { gain } else { BRIGHTEST }
    }
}
