//! Compiled cones.

use crate::{
    falloff::{CompiledFalloff, Falloff, Soft},
    number::{Ray, Rise, Scalar, Share},
    vec3::Vec3,
};

/// A cone compiled for the format `S`: a function from the versine of the angle off axis to the
/// intensity.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledCone<S: Scalar, P: Falloff = Soft> {
    pub(crate) ramp: S::Ramp,
    pub(crate) falloff: P,
    pub(crate) curve: P::Compiled<S>,
}

impl<S: Scalar, P: Falloff> CompiledCone<S, P> {
    pub(super) fn new(ramp: S::Ramp, falloff: P) -> Self {
        Self { ramp, falloff, curve: falloff.compile() }
    }

    /// Creates the cone from its parts, as [`codegen`](crate::codegen) writes them: `curve` is the
    /// falloff in the format `S`.
    pub const fn from_parts(ramp: S::Ramp, falloff: P, curve: P::Compiled<S>) -> Self {
        Self { ramp, falloff, curve }
    }

    /// Converts a versine to the scale of this cone, rounded to nearest.
    pub fn versine(&self, value: f32) -> S::Versine {
        S::versine(self.ramp, value)
    }

    /// Returns the intensity in the direction of a ray from the light, for a light with this axis.
    #[doc(hidden)]
    #[inline(always)] // `lit-hotspot` on Cortex-M0: +73 instructions without.
    pub fn at_ray<R: Ray<S>>(&self, ray: &R, axis: Vec3<S::Unit>) -> R::Share {
        self.curve.intensity(ray.rise(axis, self.ramp))
    }

    /// Returns the intensity at a versine in the scale of [`versine`](Self::versine).
    ///
    /// The intensity is exactly 0 from the outer versine or the cutoff on, and exactly 1 at versine
    /// 0 and within the hotspot. In between the intensity is monotone, except for tables. For
    /// quadratics and cubics the intensity is monotone within one step of the format, and in `Fx32`
    /// within 7 steps.
    #[inline(always)] // `table.f32` on Cortex-M0: +73 instructions without.
    pub fn at(&self, versine: S::Versine) -> S {
        match S::rise(self.ramp, versine) {
            Rise::Coarse(t) => self.curve.intensity(t).scalar(),
            Rise::Fine(t) => self.curve.intensity(t).scalar(),
        }
    }

    /// Computes the intensity at each of many versines, up to the length of the shorter slice.
    ///
    /// Each result is bit-identical to [`at`](Self::at).
    pub fn at_each(&self, versines: &[S::Versine], intensities: &mut [S]) {
        for (intensity, &versine) in intensities.iter_mut().zip(versines) {
            *intensity = self.at(versine);
        }
    }

    /// Returns the cone with another falloff.
    #[inline]
    pub fn with_falloff<Q: Falloff>(&self, falloff: Q) -> CompiledCone<S, Q> {
        CompiledCone::new(self.ramp, falloff)
    }

    /// Returns the angular falloff.
    pub fn falloff(&self) -> P {
        self.falloff
    }
}
