//! The tests that sweep and search. Each takes a few seconds, and far longer if `LUMINAIRE_FULL` is
//! set.
//!
//! `cargo test --test slow NAME::` runs the tests of one module.

#[path = "../laws/mod.rs"]
mod laws;

mod accuracy;
mod bright;
mod exhaustive;
mod half_a_code;
mod haze;
mod haze16;
mod haze_search;
mod limits;
mod narrow;
mod powers;
mod properties;
mod quick;
mod stability;
mod worst;
