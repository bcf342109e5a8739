//! The tests that sweep and search: a few seconds each, and far longer where `LUMINAIRE_FULL` is
//! set.
//!
//! `cargo test --test slow NAME::` runs one of them.

#[path = "../laws/mod.rs"]
mod laws;

mod accuracy;
mod bright;
mod exhaustive;
mod half_a_code;
mod haze;
mod haze_search;
mod limits;
mod narrow;
mod powers;
mod properties;
mod stability;
mod worst;
