//! Lights and points to compare, conformance vectors and compilers.
#![allow(dead_code, unused_imports, reason = "each test uses a part")]

pub(crate) mod avr;
pub(crate) mod compiler;
mod lights;
mod measured;
pub(crate) mod vectors;

pub(crate) use lights::{Spot, exact, is_smooth, place, points_of_light, spots, suns};
pub(crate) use measured::measured;
