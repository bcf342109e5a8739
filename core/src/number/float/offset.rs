//! The way from a point to a light in f32, and what is known of it once the root is paid for.

use super::{BRIGHTEST, FloatRamp, clamp};
use crate::number::{Arithmetic, Offset, Ray, fraction::FloatFraction};
use crate::{trig, vec3::Vec3};

/// The way back from a point to a light, and its squared length. Lambert's cosine wants it in this direction, and the
/// difference to the axis is then a sum.
#[derive(Clone, Copy, Debug)]
pub struct FloatOffset {
    back: Vec3<f32>,
    squared: f32,
}

/// The unit direction back to the light, the square of its former length, and the reciprocal of that length.
#[derive(Clone, Copy, Debug)]
pub struct FloatRay {
    back: Vec3<f32>,
    squared: f32,
    reciprocal: f32,
}

impl FloatOffset {
    /// The way back from a point to a light.
    #[inline]
    pub(super) fn between(light: Vec3<f32>, point: Vec3<f32>) -> Self {
        let back = light.zip(point, |l, p| l - p);
        Self { back, squared: back.dot(back) }
    }
}

impl Offset<f32> for FloatOffset {
    type Ray = FloatRay;
    type FineRay = FloatRay;
    type Facing = f32;

    const ROOTS_FIRST: bool = true;

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
    fn squared_distance(&self) -> f32 {
        self.squared
    }

    #[inline]
    fn ray(&self) -> FloatRay {
        self.ray_of(self.reciprocal())
    }

    #[inline]
    fn fine_ray(&self) -> FloatRay {
        self.ray()
    }

    /// Where the square is less than any normal number the point counts as on the light, and its direction is zero.
    /// Where it is beyond f32 the reciprocal is zero too, and no light arrives either.
    #[inline]
    fn reciprocal(&self) -> f32 {
        trig::inverse_sqrt(self.squared)
    }

    #[inline]
    fn ray_of(&self, reciprocal: f32) -> FloatRay {
        FloatRay { back: self.back.map(|c| c * reciprocal), squared: self.squared, reciprocal }
    }
}

/// By the kernel's root: the processor's own with `std`, else that of `libm` or `micromath`.
impl Vec3<f32> {
    /// The length; zero if its square is no normal number.
    #[inline]
    pub fn length(self) -> f32 {
        f32::offset(Vec3::default(), self).ray().distance()
    }

    /// The reciprocal of the length; zero if the square of the length is no normal number.
    #[inline]
    pub fn reciprocal_length(self) -> f32 {
        f32::offset(Vec3::default(), self).reciprocal()
    }

    /// The vector at unit length; zero if the square of its length is no normal number.
    #[inline]
    pub fn unit(self) -> Self {
        f32::offset(Vec3::default(), self).ray().direction()
    }
}

impl FloatRay {
    /// The squared difference of direction and axis.
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

    #[inline]
    fn versine(&self, axis: Vec3<f32>, _: FloatRamp) -> f32 {
        0.5 * self.twice_versine(axis)
    }

    /// On a ramp of twice the size, which halves nothing per point and changes no bit.
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

    /// The gain saturates and not the light, because the compiler sees that a product of clamped fractions is not
    /// negative, and leaves the other half of `Arithmetic::expose`'s clamp out.
    #[inline]
    fn expose(&self, fraction: f32, gain: f32) -> f32 {
        let gain = gain * (self.reciprocal * self.reciprocal);
        let fraction = if fraction < 0.0 { 0.0 } else { fraction };
        fraction * if gain < BRIGHTEST { gain } else { BRIGHTEST }
    }
}
