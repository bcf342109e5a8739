//! A compiled cone.

use crate::{
    profile::{Curve, Edge, Profile},
    scalar::{Offset, Ray, Rise, Scalar},
    vec3::Vec3,
};

/// A cone compiled for the format `S`: from the versine of the angle off axis to the intensity.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Falloff<S: Scalar, P: Profile = Edge> {
    pub(crate) ramp: S::Ramp,
    pub(crate) profile: P,
    pub(crate) curve: P::Compiled<S>,
}

impl<S: Scalar, P: Profile> Falloff<S, P> {
    pub(super) fn new(ramp: S::Ramp, profile: P) -> Self {
        Self { ramp, profile, curve: profile.compile() }
    }

    /// The falloff of these parts, as [`source`](crate::source) writes them: `curve` is the profile in the format `S`.
    pub const fn from_parts(ramp: S::Ramp, profile: P, curve: P::Compiled<S>) -> Self {
        Self { ramp, profile, curve }
    }

    /// The versine nearest to a value, in the scale of this cone.
    pub fn versine(&self, value: f32) -> S::Versine {
        S::versine(self.ramp, value)
    }

    /// The intensity in the direction of an offset from the light, of which `ray` is the ray.
    #[inline(always)]
    pub fn toward(&self, offset: &S::Offset, ray: &<S::Offset as Offset<S>>::Ray, axis: Vec3<S::Unit>) -> S {
        self.intensity(ray.rise(offset, axis, self.ramp))
    }

    #[inline(always)]
    fn intensity(&self, rise: Rise<S>) -> S {
        match rise {
            Rise::Coarse(t) => self.curve.intensity(t),
            Rise::Fine(t) => S::rounded(self.curve.intensity(t)),
        }
    }

    /// The intensity at a versine, in the scale of [`versine`](Self::versine): exactly 0 from the outer versine or a
    /// delimiter on, exactly 1 at versine 0 and within the hotspot, monotone between (tables aside, and cubics within
    /// a step of the format).
    #[inline(always)]
    pub fn at(&self, versine: S::Versine) -> S {
        self.intensity(S::rise(self.ramp, versine))
    }

    /// The same falloff with another type of profile.
    #[inline(always)]
    pub fn with_profile<Q: Profile>(&self, profile: Q) -> Falloff<S, Q> {
        Falloff::new(self.ramp, profile)
    }

    /// The edge profile.
    pub fn profile(&self) -> P {
        self.profile
    }
}
