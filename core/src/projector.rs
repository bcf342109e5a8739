//! What a light projects: gobos, shadows, and the fixture that combines them with a light.

mod fixture;
mod gobo;
mod place;
mod projection;
mod shadow;

pub use self::{
    fixture::Fixture,
    gobo::{CompiledGobo, Gobo},
    place::ProjectedPoint,
    projection::{CompiledProjection, Projection},
    shadow::Shadow,
};
