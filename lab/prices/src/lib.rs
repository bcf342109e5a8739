//! Measures the error of each kernel, and its time where there is a clock, on the same functions
//! whose instructions the firmware counts.
//!
//! Each measurement is reported as a line of words, so that a terminal, a browser and
//! `cargo xtask measure` read the same. Errors are the same in every run; times are not, and come
//! with their spread.
#![forbid(unsafe_code)]

mod accuracy;
mod random;
mod site;
mod time;
#[cfg(target_arch = "wasm32")]
mod web;

pub use accuracy::{Accuracy, Kind};
pub use time::{BATCH, Clock, Times};
