//! One surface point and one compiled light: how much of the light arrives.

use crate::{
    color::Rgb,
    cone::Falloff,
    profile::{Edge, Profile},
    scalar::{Offset, Ray, Scalar},
    vec3::Vec3,
};

/// A spotlight compiled for the format `S`. Made by [`Spot::compile`](crate::Spot::compile).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledSpot<S: Scalar, P: Profile = Edge> {
    pub(crate) position: Vec3<S::Length>,
    pub(crate) axis: Vec3<S::Unit>,
    pub(crate) falloff: Falloff<S, P>,
    pub(crate) outside: S,
    pub(crate) intensity: S::Gain,
    pub(crate) color: Rgb<S>,
}

impl<S: Scalar, P: Profile> CompiledSpot<S, P> {
    /// The light that arrives at a surface point, before the colours: falloff, inverse-square distance and
    /// Lambert's cosine. 1 is full scale; the unit of `point` is that of the light's position, `normal` has unit
    /// length.
    ///
    /// No root is paid for a surface that faces away, or for a point that is clearly outside the cone; what is
    /// skipped is exactly zero, so the answer has the bits of [`irradiance_unskipped`](Self::irradiance_unskipped).
    #[inline(always)]
    pub fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        let offset = S::offset(self.position, point);
        let facing = offset.facing(normal);
        if S::Offset::faces_away(facing) || offset.is_outside(self.axis, self.outside) {
            return S::Irradiance::default();
        }
        self.arrive(offset.ray(), facing)
    }

    /// As [`irradiance`](Self::irradiance), with every step done for every point: the form without branches, which
    /// compilers turn into vector instructions.
    #[inline(always)]
    pub fn irradiance_unskipped(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        let offset = S::offset(self.position, point);
        self.arrive(offset.ray(), offset.facing(normal))
    }

    /// The falloff of the cone alone at a point: in [0, 1].
    #[inline(always)]
    pub fn falloff(&self, point: Vec3<S::Length>) -> S {
        self.falloff.toward(S::offset(self.position, point).ray(), self.axis)
    }

    /// The light's linear colour.
    pub fn color(&self) -> Rgb<S> {
        self.color
    }

    /// The edge profile of the cone.
    pub fn profile(&self) -> P {
        self.falloff.profile()
    }

    /// The same light with another type of profile: what turns a choice made at run time into a type, once per
    /// light and not once per point.
    pub fn with_profile<Q: Profile>(&self, profile: Q) -> CompiledSpot<S, Q> {
        CompiledSpot {
            position: self.position,
            axis: self.axis,
            falloff: self.falloff.with_profile(profile),
            outside: self.outside,
            intensity: self.intensity,
            color: self.color,
        }
    }

    #[inline(always)]
    fn arrive(
        &self,
        ray: <S::Offset as Offset<S>>::Ray,
        facing: <S::Offset as Offset<S>>::Facing,
    ) -> S::Irradiance {
        let falloff = self.falloff.toward(ray, self.axis);
        ray.expose(falloff.times(ray.cosine(facing)), self.intensity)
    }
}
