//! What a light projects: gobos, shadows, and the fixture that combines them with a light.

mod fixture;
mod gobo;
mod projected;
mod projection;
mod shadow;

pub use self::{
    fixture::Fixture,
    gobo::{CompiledGobo, Gobo},
    projected::ProjectedPoint,
    projection::{CompiledProjection, Projection},
    shadow::Shadow,
};
