//! Shading of one surface point by one compiled light.

mod change;
mod directional;
mod placed;
mod point;
mod quick;
mod spot;

pub use self::{
    directional::CompiledDirectionalLight, point::CompiledPointLight, quick::QuickSpotLight,
    spot::CompiledSpotLight,
};

use crate::{
    color::Rgb,
    number::{Offset, Ray, Scalar},
    specular::SpecularLobe,
    vec3::Vec3,
};

/// A surface point, with its normal and the direction to the eye.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfacePoint<S: Scalar> {
    /// The position, in the unit of the lights' positions.
    pub point: Vec3<S::Length>,
    /// The normal, of unit length.
    pub normal: Vec3<S>,
    /// The direction from the point to the eye, of unit length. Unused for a matte surface.
    pub view: Vec3<S::Unit>,
}

impl<S: Scalar> SurfacePoint<S> {
    /// Creates a point of a matte surface, which looks the same from every side.
    #[inline]
    pub fn matte(point: Vec3<S::Length>, normal: Vec3<S>) -> Self {
        Self { point, normal, view: Vec3::default() }
    }

    /// Creates a point that is seen by an eye. The direction to the eye takes one square root per
    /// point, whatever the number of lights.
    #[inline]
    pub fn seen_from(eye: Vec3<S::Length>, point: Vec3<S::Length>, normal: Vec3<S>) -> Self {
        Self { point, normal, view: S::offset(point, eye).ray().direction() }
    }
}

/// Light that arrives at a surface, not yet multiplied by the light's colours; 1 is full scale.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Incident<I> {
    /// The product of intensity, falloff, attenuation and Lambert's cosine.
    pub diffuse: I,
    /// The product of intensity, falloff, attenuation and the specular lobe.
    pub specular: I,
}

/// A compiled light of any kind.
pub trait LightModel<S: Scalar>: Copy + core::fmt::Debug {
    /// Returns the linear colours of the light: the diffuse and the specular colour.
    fn colors(&self) -> [Rgb<S>; 2];
    /// Computes the light at a surface whose specular lobe is of the type `H`.
    ///
    /// With `skips`, points that receive no light are rejected before the square root. The result
    /// is bit-identical with and without `skips`.
    fn evaluate<H: SpecularLobe>(
        &self,
        surface: &SurfacePoint<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Incident<S::Irradiance>;
    /// Returns `false` only if no point within `radius` of `center` receives light.
    fn can_reach(&self, _center: Vec3<S::Length>, _radius: S::Length) -> bool {
        true
    }
}

/// Returns the specular lobe if the light hits the front of a surface, else zero.
#[inline]
fn lobe<S: Scalar, H: SpecularLobe>(
    highlight: &H::Constants<S>,
    (normal, view): (Vec3<S>, Vec3<S::Unit>),
    incoming: Vec3<S::Unit>,
    cosine: S,
) -> S {
    if !H::SHINES {
        return S::ZERO;
    }
    let lobe = H::lobe(highlight, incoming, normal, view);
    if cosine > S::ZERO { lobe } else { S::ZERO }
}
