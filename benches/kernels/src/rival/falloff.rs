//! The usual falloffs of the field in f32, from the cosine of the angle off axis.

use core::marker::PhantomData;

use luminaire::{falloff::ListedFalloff, light::CompiledCone};

use crate::{kernel::Kernel, value::Value};

/// A kernel from a cosine to an intensity.
macro_rules! from_cosine {
    ($type:ty $(, $($parameter:tt)*)?) => {
        impl$(<$($parameter)*>)? Kernel for $type {
            type Place = f32;
            type Input = f32;
            type Output = f32;

            fn input(&self, versine: &f32) -> f32 {
                cosine(*versine)
            }

            #[inline(always)]
            fn evaluate(&self, cosine: &f32) -> f32 {
                self.at(*cosine)
            }

            #[inline(always)]
            fn touch(cosine: &f32) -> u32 {
                cosine.bits()
            }
        }
    };
}

from_cosine!(Powf<P>, P: Power);
from_cosine!(CosineTable);
from_cosine!(Gltf);
from_cosine!(CosineFalloff<P>, P: ListedFalloff);

/// The cosine nearest to a versine.
pub(crate) fn cosine(versine: f32) -> f32 {
    (1.0 - f64::from(versine)) as f32
}

/// A library's power function.
pub trait Power: Copy {
    /// `x^n`.
    fn powf(x: f32, n: f32) -> f32;
}

/// The crate `libm`: the same bits on every target.
#[derive(Clone, Copy, Debug)]
pub struct Libm;

/// The platform's own library.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug)]
pub struct Std;

impl Power for Libm {
    #[inline(always)]
    fn powf(x: f32, n: f32) -> f32 {
        libm::powf(x, n)
    }
}

#[cfg(feature = "std")]
impl Power for Std {
    #[inline(always)]
    fn powf(x: f32, n: f32) -> f32 {
        x.powf(n)
    }
}

/// The power of the cosine: D. R. Warn, *Lighting Controls for Synthetic Images*, SIGGRAPH 1983,
/// and OpenGL's `GL_SPOT_EXPONENT`.
#[derive(Clone, Copy, Debug)]
pub struct Powf<P> {
    exponent: f32,
    library: PhantomData<P>,
}

impl<P: Power> Powf<P> {
    /// The power with this exponent.
    pub fn new(exponent: f32) -> Self {
        Self { exponent, library: PhantomData }
    }

    /// The intensity at a cosine.
    #[inline(always)]
    pub fn at(&self, cosine: f32) -> f32 {
        P::powf(if cosine > 0.0 { cosine } else { 0.0 }, self.exponent)
    }
}

/// The power of the cosine from a table of 256 entries over the cosine, with linear interpolation.
#[derive(Clone, Copy, Debug)]
pub struct CosineTable {
    entries: [f32; 256],
}

impl CosineTable {
    /// The table of the power with this exponent.
    pub fn new(exponent: f32) -> Self {
        Self { entries: core::array::from_fn(|i| libm::powf(i as f32 / 255.0, exponent)) }
    }

    /// The intensity at a cosine.
    #[inline(always)]
    pub fn at(&self, cosine: f32) -> f32 {
        let place = cosine.clamp(0.0, 1.0) * 255.0;
        let index = (place as usize).min(254);
        let (from, to) = (self.entries[index], self.entries[index + 1]);
        from + (to - from) * (place - index as f32)
    }
}

/// The spot of glTF's `KHR_lights_punctual` with an inner angle of 0, as the specification computes
/// it: scale and offset ahead of time, the former with the 0.001 that keeps it from a division by
/// zero.
#[derive(Clone, Copy, Debug)]
pub struct Gltf {
    scale: f32,
    offset: f32,
}

impl Gltf {
    /// The spot with this cosine of its outer half angle.
    pub fn new(outer: f32) -> Self {
        let scale = 1.0 / (1.0 - outer).max(0.001);
        Self { scale, offset: -outer * scale }
    }

    /// The intensity at a cosine.
    #[inline(always)]
    pub fn at(&self, cosine: f32) -> f32 {
        let t = (cosine * self.scale + self.offset).clamp(0.0, 1.0);
        t * t
    }
}

/// f32 with the versine by `1 - l.s`, which cancels in narrow beams: both numbers are near 1. The demo
/// compares it; it has no price.
#[derive(Clone, Copy, Debug)]
pub struct CosineFalloff<P: ListedFalloff> {
    falloff: CompiledCone<f32, P>,
}

impl<P: ListedFalloff> CosineFalloff<P> {
    /// Wraps a compiled cone.
    pub fn new(falloff: CompiledCone<f32, P>) -> Self {
        Self { falloff }
    }

    /// The intensity at a cosine.
    #[inline(always)]
    pub fn at(&self, cosine: f32) -> f32 {
        self.falloff.at(1.0 - cosine)
    }
}
