//! What a light projects: patterns and shadows, and the light with both as it hangs on a truss.

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
