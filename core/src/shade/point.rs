//! Point lights, compiled.

use super::{Incident, LightModel, light_facing, lobe, sealed::Sealed};
use crate::{
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    number::{Fraction, Offset, Ray, Scalar, Share},
    points::SurfacePoint,
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

    /// Returns the irradiance of a surface that faces the light at a point, not yet multiplied by the colours: see
    /// [`CompiledSpotLight::irradiance_facing`](crate::light::CompiledSpotLight::irradiance_facing). At the light itself it is zero.
    #[inline]
    pub fn irradiance_facing(&self, point: Vec3<S::Length>) -> S::Irradiance {
        let offset = S::Offset::between(self.position, point);
        light_facing::<S, (), A>((&self.attenuation, self.intensity, self.fine_below), (), &offset)
    }

    /// Returns whether the evaluation at a point is fine: see
    /// [`CompiledSpotLight::is_fine`](crate::light::CompiledSpotLight::is_fine).
    #[cfg(feature = "arithmetic")]
    pub fn is_fine(&self, point: Vec3<S::Length>) -> bool {
        S::Offset::between(self.position, point).is_near(self.fine_below)
    }

    /// Returns the position of the light.
    pub fn position(&self) -> Vec3<S::Length> {
        self.position
    }

    /// Creates a light from its fields, as [`codegen`](crate::codegen) writes them.
    ///
    /// `fine_below` is the result of `Errors::fine_below`; the colours are the diffuse and the
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

impl<S: Scalar, A: Attenuation> Sealed for CompiledPointLight<S, A> {}

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
        let SurfacePoint { point, normal, view } = *surface;
        let Self { position, ref attenuation, intensity, fine_below, .. } = *self;
        let offset = S::Offset::between(position, point);
        if offset.is_near(fine_below) {
            return self.evaluate_finely::<H>(offset, (normal, view), highlight);
        }
        let facing = offset.facing(normal);
        if skips && (S::Offset::faces_away(facing) || A::is_beyond::<S, _>(attenuation, &offset)) {
            return Incident::default();
        }
        let ray = offset.ray();
        let cosine = ray.cosine(facing, normal);
        let light = |share| A::light(attenuation, &offset, &ray, share, intensity);
        let diffuse = light(cosine.value());
        if !H::SHINES {
            return Incident { diffuse, ..Incident::default() };
        }
        let lobe = lobe::<S, H>(highlight, (normal, view), ray.direction(), cosine.value().scalar());
        Incident { diffuse, specular: light(Share::of_scalar(lobe)) }
    }
}

impl<S: Scalar, A: Attenuation> CompiledPointLight<S, A> {
    /// Evaluates a point near the light: see `CompiledSpotLight::evaluate_finely`.
    #[cold]
    #[inline(never)]
    fn evaluate_finely<H: SpecularLobe>(
        &self,
        offset: S::Offset,
        (normal, view): (Vec3<S>, Vec3<S::Unit>),
        highlight: &H::Constants<S>,
    ) -> Incident<S::Irradiance> {
        let facing = offset.facing(normal);
        if S::Offset::faces_far_away(facing) {
            return Incident::default();
        }
        let light = (&self.attenuation, self.intensity, self.fine_below);
        super::evaluate_finely::<S, (), A, H>(light, (), (&offset, facing), (normal, view), highlight)
    }
}
