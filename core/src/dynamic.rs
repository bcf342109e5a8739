//! Run-time choice: lights of any kind, and the effects that a scene requires.

pub use crate::{
    any_light::{AnyLight, CompiledAnyLight},
    effect::{Effect, Effects},
    plan::RenderPlan,
};
