//! One surface point and one compiled light: how much of the light arrives.

mod directional;
mod placed;
mod point;
mod spot;

pub use self::{directional::CompiledDirectionalLight, point::CompiledPointLight, spot::CompiledSpotLight};

use crate::{
    color::Rgb,
    number::{Offset, Ray, Scalar},
    specular::SpecularLobe,
    vec3::Vec3,
};

/// A point of a surface, as a light and an eye see it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfacePoint<S: Scalar> {
    /// Where the point is, in the unit of the lights' positions.
    pub point: Vec3<S::Length>,
    /// The normal, of unit length.
    pub normal: Vec3<S>,
    /// The direction from the point to the eye, of unit length. A matt surface does not ask for it.
    pub view: Vec3<S::Unit>,
}

impl<S: Scalar> SurfacePoint<S> {
    /// A point of a matt surface, the same from every side.
    #[inline]
    pub fn matte(point: Vec3<S::Length>, normal: Vec3<S>) -> Self {
        Self { point, normal, view: Vec3::default() }
    }

    /// A point as an eye sees it: one root, which all lights share.
    #[inline]
    pub fn seen_from(eye: Vec3<S::Length>, point: Vec3<S::Length>, normal: Vec3<S>) -> Self {
        Self { point, normal, view: S::offset(point, eye).ray().direction() }
    }
}

/// What arrives of a light, before its colours: 1 is full scale.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Incident<I> {
    /// Falloff, distance and Lambert's cosine.
    pub diffuse: I,
    /// Falloff, distance and the lobe of the highlight.
    pub specular: I,
}

/// A compiled light of any kind.
pub trait LightModel<S: Scalar>: Copy + core::fmt::Debug {
    /// The linear colours of its diffuse light and of its highlights.
    fn colors(&self) -> [Rgb<S>; 2];
    /// What arrives at a surface whose highlight is of the kind `H`. With `skips`, points where nothing can arrive are
    /// left before the root is paid for, with the same bits.
    fn evaluate<H: SpecularLobe>(
        &self,
        surface: &SurfacePoint<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Incident<S::Irradiance>;
}

/// The lobe of a highlight where the light falls on the front of a surface, and zero elsewhere.
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
