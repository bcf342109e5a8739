//! Known faults of spotlights in other projects, with one test for each.
//!
//! A test contains the faulty formula as its project has it. It bounds the formula's error from
//! both sides in the case that breaks it, and then tests the same case on the kernel, in every
//! format that supports the case. The comment above a formula names its source: project, file and,
//! if there is one, the thread that reported the fault. Shaders compute in f32, and so do their
//! formulas here. A project may have corrected its formula since.
//!
//! `cargo test --test suite regressions:: -- --nocapture --test-threads 1` prints the errors of
//! both.

mod case;
mod clamps;
mod distances;
mod edges;
mod powers;
mod precision;
