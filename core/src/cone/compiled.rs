//! A compiled cone.

use crate::{
    falloff::{Curve, Falloff, SoftOrHard},
    number::{Ray, Rise, Scalar, Share},
    vec3::Vec3,
};

/// A cone compiled for the format `S`: from the versine of the angle off axis to the intensity.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledCone<S: Scalar, P: Falloff = SoftOrHard> {
    pub(crate) ramp: S::Ramp,
    pub(crate) profile: P,
    pub(crate) curve: P::Compiled<S>,
}

impl<S: Scalar, P: Falloff> CompiledCone<S, P> {
    pub(super) fn new(ramp: S::Ramp, profile: P) -> Self {
        Self { ramp, profile, curve: profile.compile() }
    }

    /// The falloff of these parts, as [`codegen`](crate::codegen) writes them: `curve` is the profile in the format `S`.
    pub const fn from_parts(ramp: S::Ramp, profile: P, curve: P::Compiled<S>) -> Self {
        Self { ramp, profile, curve }
    }

    /// The versine nearest to a value, in the scale of this cone.
    pub fn versine(&self, value: f32) -> S::Versine {
        S::versine(self.ramp, value)
    }

    /// The intensity in the direction of a ray from the light, which has an axis.
    #[inline(always)] // `spot-soft-lambert-hotspot` on Cortex-M0: +73 without.
    pub fn toward<R: Ray<S>>(&self, ray: &R, axis: Vec3<S::Unit>) -> R::Share {
        self.curve.intensity(ray.rise(axis, self.ramp))
    }

    /// The intensity at a versine, in the scale of [`versine`](Self::versine): exactly 0 from the outer versine or a
    /// cutoff on, exactly 1 at versine 0 and within the hotspot, monotone between (tables aside, and cubics within
    /// a step of the format).
    #[inline(always)] // `table.f32` on Cortex-M0: +73 without.
    pub fn at(&self, versine: S::Versine) -> S {
        match S::rise(self.ramp, versine) {
            Rise::Coarse(t) => self.curve.intensity(t),
            Rise::Fine(t) => self.curve.intensity(t).rounded(),
        }
    }

    /// The same falloff with another type of profile.
    #[inline]
    pub fn with_profile<Q: Falloff>(&self, profile: Q) -> CompiledCone<S, Q> {
        CompiledCone::new(self.ramp, profile)
    }

    /// The edge profile.
    pub fn profile(&self) -> P {
        self.profile
    }
}
