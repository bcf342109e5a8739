//! The step falloff.

use super::{CompiledFalloff, Falloff, Formula};
use crate::{
    model::plain,
    number::{Fraction, Scalar},
};

/// The step: full intensity up to the edge and 0 from the edge on, without a multiply. It models an
/// umbra without a penumbra, and OpenGL's spotlight with exponent 0.
///
/// Beam, field and outer angle coincide. At the edge itself the intensity is 0, as in every
/// falloff.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Step;

plain!(Step);

impl Falloff for Step {
    type Compiled<S: Scalar> = Self;

    fn formula(&self) -> Formula<'_> {
        Formula::Step
    }

    fn beam_versine(self) -> f32 {
        1.0
    }

    fn field_versine(self) -> f32 {
        1.0
    }

    fn steepness(self, _: f32) -> f32 {
        1.0
    }

    fn integral(self, u: f32) -> f32 {
        u
    }
}

impl<S: Scalar> CompiledFalloff<S> for Step {
    #[inline]
    fn intensity<F: Fraction<S>>(self, t: F) -> F::Value {
        t.step()
    }
}
