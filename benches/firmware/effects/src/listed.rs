//! The models in the library's lists, each with the effect that shows its cost.

use luminaire::light::{CompiledMaterial, CompiledSpotLight};
#[allow(clippy::wildcard_imports, reason = "the types of the lists")]
use luminaire::{attenuation::*, falloff::*, specular::*};

use crate::constants::DIRECTIONAL;
use crate::format::{Format, Irradiance, Light, Surface};

/// A model of a list, and the effect that shows its cost.
pub trait Listed {
    /// The name of the program.
    const NAME: &'static str;
    /// The compiled light or material that has the model.
    type Constant;
    /// The value of the constant, which the build script has written.
    const CONSTANT: Self::Constant;
    /// The result of the effect.
    type Output;

    /// The effect at a surface point.
    fn effect(surface: Surface) -> Self::Output;
}

// The build script writes the implementations, each with its constant.
include!(concat!(env!("OUT_DIR"), "/listed.rs"));
