//! Spotlights, compiled.

use super::{Arrival, Light, Surface, lobe};
use crate::{
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    cone::Falloff,
    profile::{Edge, Profile},
    scalar::{Fraction, Offset, Ray, Scalar},
    specular::{Matte, Specular},
    vec3::Vec3,
};

/// A spotlight compiled for the format `S`. Made by [`Spot::compile`](crate::Spot::compile).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledSpot<S: Scalar, P: Profile = Edge, A: Attenuation = InverseSquare> {
    pub(crate) position: Vec3<S::Length>,
    pub(crate) axis: Vec3<S::Unit>,
    pub(crate) falloff: Falloff<S, P>,
    pub(crate) outside: S,
    pub(crate) attenuation: A::Constants<S>,
    pub(crate) intensity: S::Gain,
    pub(crate) color: Rgb<S>,
    pub(crate) specular_color: Rgb<S>,
}

impl<S: Scalar, P: Profile, A: Attenuation> CompiledSpot<S, P, A> {
    /// The light of these parts, as [`source`](crate::source) writes them: `outside` is the bound by which points outside
    /// the cone are rejected, and the colours are the diffuse and the specular one.
    pub const fn from_parts(
        position: Vec3<S::Length>,
        axis: Vec3<S::Unit>,
        falloff: Falloff<S, P>,
        outside: S,
        attenuation: A::Constants<S>,
        intensity: S::Gain,
        [color, specular_color]: [Rgb<S>; 2],
    ) -> Self {
        Self { position, axis, falloff, outside, attenuation, intensity, color, specular_color }
    }

    /// The light that arrives at a surface point, before the colours: falloff, distance and Lambert's cosine. 1 is
    /// full scale; the unit of `point` is that of the light's position, `normal` has unit length.
    ///
    /// No root is paid for a surface that faces away, or for a point that is clearly outside the cone or beyond the
    /// range; what is skipped is exactly zero, so the answer has the bits of
    /// [`irradiance_unskipped`](Self::irradiance_unskipped).
    #[inline(always)]
    pub fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.arrive::<Matte>(&Surface::matte(point, normal), &(), true).diffuse
    }

    /// As [`irradiance`](Self::irradiance), with every step done for every point: the form without branches, which
    /// compilers turn into vector instructions.
    #[inline(always)]
    pub fn irradiance_unskipped(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.arrive::<Matte>(&Surface::matte(point, normal), &(), false).diffuse
    }

    /// The falloff of the cone alone at a point: in [0, 1].
    #[inline(always)]
    pub fn falloff(&self, point: Vec3<S::Length>) -> S {
        let offset = S::offset(self.position, point);
        self.falloff.toward(&offset, &offset.ray(), self.axis)
    }

    /// The light's linear colour.
    pub fn color(&self) -> Rgb<S> {
        self.color
    }

    /// The linear colour of the light's highlights.
    pub fn specular_color(&self) -> Rgb<S> {
        self.specular_color
    }

    /// The edge profile of the cone.
    pub fn profile(&self) -> P {
        self.falloff.profile()
    }

    /// The same light with another type of profile: what turns a choice made at run time into a type, once per
    /// light and not once per point.
    pub fn with_profile<Q: Profile>(&self, profile: Q) -> CompiledSpot<S, Q, A> {
        CompiledSpot {
            position: self.position,
            axis: self.axis,
            falloff: self.falloff.with_profile(profile),
            outside: self.outside,
            attenuation: self.attenuation,
            intensity: self.intensity,
            color: self.color,
            specular_color: self.specular_color,
        }
    }
}

impl<S: Scalar, P: Profile, A: Attenuation> Light<S> for CompiledSpot<S, P, A> {
    fn color(&self) -> Rgb<S> {
        self.color
    }

    fn specular_color(&self) -> Rgb<S> {
        self.specular_color
    }

    #[inline(always)]
    fn arrive<H: Specular>(
        &self,
        surface: &Surface<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Arrival<S::Irradiance> {
        let offset = S::offset(self.position, surface.point);
        let facing = offset.facing(surface.normal);
        if skips
            && (S::Offset::faces_away(facing)
                || offset.is_outside(self.axis, self.outside)
                || A::is_beyond::<S>(&self.attenuation, &offset))
        {
            return Arrival::default();
        }
        let ray = offset.ray();
        let falloff = self.falloff.toward(&offset, &ray, self.axis);
        let cosine = ray.cosine(facing);
        let expose = |fraction| A::expose(&self.attenuation, &offset, &ray, fraction, self.intensity);
        let diffuse = expose(cosine.of(falloff));
        if !H::SHINES {
            return Arrival { diffuse, specular: S::Irradiance::default() };
        }
        let lobe = lobe::<S, H>(highlight, surface, ray.direction(), cosine.scalar());
        Arrival { diffuse, specular: expose(falloff.times(lobe)) }
    }
}
