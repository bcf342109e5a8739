//! What each kernel errs, and how long it takes where there is a clock: measured on the very functions that firmware
//! counts the instructions of.
//!
//! Each measurement is told as a line of words, so that a terminal, a browser and `cargo xtask measure` read the same.
//! Errors are the same in every run; times are not, and come with their spread.
#![forbid(unsafe_code)]

mod accuracy;
mod random;
mod site;
mod time;
#[cfg(target_arch = "wasm32")]
mod web;

pub use accuracy::{Accuracy, Kind};
pub use time::{BATCH, Clock, Times};
