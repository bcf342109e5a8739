//! The tests that sweep and search. Each takes a few seconds, and far longer if `LUMINAIRE_FULL` is
//! set, as `cargo xtask full` does.
//!
//! A plain `cargo test` leaves them out. `cargo test --test slow NAME::` runs the tests of one
//! module.

mod bound;
mod exhaustive;
mod half_a_code;
mod haze;
mod haze_search;
mod highlights;
mod limits;
mod powers;
mod stability;
