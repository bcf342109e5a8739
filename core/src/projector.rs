//! What a light projects: gobos, shadows, and the fixture that combines them with a light.

mod fixture;
mod gobo;
mod projection;
mod shadow;

pub use self::{
    fixture::Fixture,
    gobo::{CompiledGobo, Gobo},
    projection::{CompiledProjection, Projection},
    shadow::Shadow,
};
pub use crate::number::ProjectedPoint;
