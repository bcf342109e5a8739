//! f32 with the versine by `1 - l.s`, which cancels in narrow beams: both numbers are near 1. The demo
//! compares it; it has no price.

use luminaire::{falloff::ListedFalloff, light::CompiledCone};

use crate::{kernel::Kernel, value::Value};

/// A compiled cone whose input is the cosine of the angle off axis.
#[derive(Clone, Copy, Debug)]
pub struct CosineFalloff<P: ListedFalloff> {
    falloff: CompiledCone<f32, P>,
}

impl<P: ListedFalloff> CosineFalloff<P> {
    /// Wraps a compiled cone.
    pub fn new(falloff: CompiledCone<f32, P>) -> Self {
        Self { falloff }
    }
}

impl<P: ListedFalloff> Kernel for CosineFalloff<P> {
    type Place = f32;
    type Input = f32;
    type Output = f32;

    fn input(&self, versine: &f32) -> f32 {
        cosine(*versine)
    }

    #[inline(always)]
    fn evaluate(&self, cosine: &f32) -> f32 {
        self.falloff.at(1.0 - cosine)
    }

    #[inline(always)]
    fn touch(cosine: &f32) -> u32 {
        cosine.bits()
    }
}

/// The cosine nearest to a versine.
pub(crate) fn cosine(versine: f32) -> f32 {
    (1.0 - f64::from(versine)) as f32
}
