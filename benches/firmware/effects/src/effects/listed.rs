//! The effects of the models in the library's lists.

use luminaire::light::{CompiledMaterial, CompiledSpotLight};
#[allow(clippy::wildcard_imports, reason = "the types of the lists")]
use luminaire::{attenuation::*, falloff::*, specular::*};

use super::{Effect, Effects, Entry, Visit};
use crate::constants::DIRECTIONAL;
use crate::{Format, Inputs, Irradiance, Light, Surface};

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

// The build script writes the models: for each, its constant as an implementation of `Listed`, and
// its row of the catalogue in the functions `falloffs`, `attenuations` and `lobes`.
include!(concat!(env!("OUT_DIR"), "/listed.rs"));
