//! Directional lights, compiled.

use super::{Incident, LightModel, lobe, sealed::Sealed};
use crate::{
    color::Rgb,
    number::Scalar,
    points::SurfacePoint,
    specular::{NoSpecular, SpecularLobe},
    vec3::Vec3,
};

/// A directional light compiled for the format `S`.
///
/// Made by [`DirectionalLight::compile`](crate::DirectionalLight::compile).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledDirectionalLight<S: Scalar> {
    pub(crate) direction: Vec3<S::Unit>,
    pub(crate) intensity: S::Gain,
    pub(crate) color: Rgb<S>,
    pub(crate) specular_color: Rgb<S>,
}

impl<S: Scalar> CompiledDirectionalLight<S> {
    /// Returns the irradiance at a surface with this normal, not yet multiplied by the colours.
    ///
    /// The irradiance is the intensity times Lambert's cosine.
    #[inline]
    pub fn irradiance(&self, normal: Vec3<S>) -> S::Irradiance {
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(Vec3::default(), normal), &(), false).diffuse
    }

    /// Returns the irradiance of a surface that faces the light, not yet multiplied by the colours: the intensity.
    #[inline]
    pub fn irradiance_facing(&self) -> S::Irradiance {
        S::ONE.light(self.intensity)
    }

    /// Creates a light from its fields, as [`codegen`](crate::codegen) writes them.
    ///
    /// The two colours are first the diffuse and then the specular colour.
    pub const fn from_parts(
        direction: Vec3<S::Unit>,
        intensity: S::Gain,
        [color, specular_color]: [Rgb<S>; 2],
    ) -> Self {
        Self { direction, intensity, color, specular_color }
    }
}

impl<S: Scalar> Sealed for CompiledDirectionalLight<S> {}

impl<S: Scalar> LightModel<S> for CompiledDirectionalLight<S> {
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
        let cosine = S::incidence(self.direction, surface.normal);
        // The comparison is false for a cosine of NaN, so NaN is skipped, too.
        let is_lit = cosine > S::ZERO;
        if skips && H::SHINES && !is_lit {
            return Incident::default();
        }
        let lobe = lobe::<S, H>(highlight, (surface.normal, surface.view), self.direction, cosine);
        Incident { diffuse: cosine.light(self.intensity), specular: lobe.light(self.intensity) }
    }
}
