//! The quick tests of the kernel, one module for each subject.
//!
//! `cargo test --test suite NAME::` runs the tests of one module.

#[path = "../laws/mod.rs"]
mod laws;

mod accuracy;
mod any_bits;
mod any_light;
mod bright;
mod changes;
mod cones;
mod decay;
mod display;
mod display_ramp;
mod dmx;
mod domain;
mod draw;
mod falloff_ends;
mod figures;
mod generated;
mod gobo;
mod haze16;
mod haze16_error;
mod haze_laws;
mod haze_rays;
mod kept;
mod lit;
mod many_points;
mod measured;
mod numbers;
mod operations;
mod outputs;
mod palette;
mod projection;
mod properties;
mod refusals;
mod rows;
mod setup;
mod shadow;
mod soft_edges;
mod tables;
mod totality;
mod two_angles;
mod zoom;
