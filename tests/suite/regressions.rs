//! The bugs of the field, held: what spotlights in other projects got wrong, one test each.
//!
//! A test writes the faulty formula out as its project has it, shows what it makes of the case that
//! breaks it, in figures with a bound on either side, and asks the same of the kernel in every
//! format that holds the case. A formula's source stands above it: project, file, and the thread
//! that found the fault where there is one. Shaders compute in f32, and so do their formulas here.
//! A project may have mended its formula since.
//!
//! `cargo test --test suite regressions:: -- --nocapture --test-threads 1` prints what both
//! measure.

mod case;
mod clamps;
mod distances;
mod edges;
mod powers;
mod precision;
