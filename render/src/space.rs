//! Vectors, and bounds of points and of directions.

pub(crate) mod bounds;
pub(crate) mod directions;
pub(crate) mod vector;
