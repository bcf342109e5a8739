//! Point lights, compiled.

use super::{
    Incident, LightModel, SurfacePoint,
    placed::{Placed, Stand},
};
use crate::{
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    number::{Ray, Scalar},
    specular::{NoSpecular, SpecularLobe},
    vec3::Vec3,
};

/// A point light compiled for the format `S`. Made by
/// [`PointLight::compile`](crate::PointLight::compile).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledPointLight<S: Scalar, A: Attenuation = InverseSquare> {
    pub(crate) position: Vec3<S::Length>,
    pub(crate) attenuation: A::Constants<S>,
    pub(crate) intensity: S::Gain,
    pub(crate) fine_below: u32,
    pub(crate) color: Rgb<S>,
    pub(crate) specular_color: Rgb<S>,
}

impl<S: Scalar, A: Attenuation> CompiledPointLight<S, A> {
    /// Returns the irradiance at a surface point, not yet multiplied by the colours; 1 is full
    /// scale.
    ///
    /// The irradiance is the product of intensity, attenuation and Lambert's cosine.
    ///
    /// Points with exactly zero light are rejected before the square root, as by
    /// [`CompiledSpotLight::irradiance`](crate::light::CompiledSpotLight::irradiance).
    #[inline]
    pub fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), true).diffuse
    }

    /// Returns the result of [`irradiance`](Self::irradiance), but without early-outs.
    #[inline]
    pub fn irradiance_unskipped(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), false).diffuse
    }

    /// Returns the light's linear colour.
    pub fn color(&self) -> Rgb<S> {
        self.color
    }

    /// Returns the linear colour of the light's specular highlights.
    pub fn specular_color(&self) -> Rgb<S> {
        self.specular_color
    }

    /// Creates a light from its fields, as [`codegen`](crate::codegen) writes them.
    ///
    /// `fine_below` is the result of `Arithmetic::fine_below`; the colours are the diffuse and the
    /// specular colour.
    pub const fn from_parts(
        position: Vec3<S::Length>,
        attenuation: A::Constants<S>,
        intensity: S::Gain,
        fine_below: u32,
        [color, specular_color]: [Rgb<S>; 2],
    ) -> Self {
        Self { position, attenuation, intensity, fine_below, color, specular_color }
    }
}

impl<S: Scalar, A: Attenuation> Placed<S, A> for CompiledPointLight<S, A> {
    #[inline]
    fn place(&self) -> Stand<'_, S, A> {
        let Self { position, ref attenuation, intensity, fine_below, .. } = *self;
        Stand { position, attenuation, intensity, fine_below }
    }

    #[inline]
    fn is_outside(&self, _: &S::Offset) -> bool {
        false
    }

    #[inline]
    fn falloff<R: Ray<S>>(&self, _: &R) -> Option<R::Share> {
        None
    }
}

impl<S: Scalar, A: Attenuation> LightModel<S> for CompiledPointLight<S, A> {
    #[inline]
    fn colors(&self) -> [Rgb<S>; 2] {
        [self.color, self.specular_color]
    }

    #[inline]
    fn evaluate<H: SpecularLobe>(
        &self,
        surface: &SurfacePoint<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Incident<S::Irradiance> {
        self.evaluate_at::<H>(surface, highlight, skips)
    }
}
