//! Measures the error and the time of each kernel: the same functions whose instructions the
//! firmware counts.
//!
//! Each measurement is a line, `name value unit`, on the host as in a browser. Errors are the same in every
//! run. Times vary, and are given with their quartiles.
#![forbid(unsafe_code)]

mod accuracy;
mod site;
mod time;
#[cfg(target_arch = "wasm32")]
mod web;

use std::fmt::{Display, Write as _};

pub use accuracy::errors;
pub use time::{BATCH, Clock, time};

use luminaire_kernels::Row;

/// Lines of measurements.
#[derive(Debug, Default)]
pub(crate) struct Lines(pub(crate) String);

impl Lines {
    /// Adds a figure of a kernel.
    pub(crate) fn add(&mut self, row: Row, value: impl Display, unit: &str) {
        // Writing to a string does not fail.
        let _ = writeln!(self.0, "{}.{} {value} {unit}", row.kernel, row.format);
    }
}

/// Rounds to four digits, which are more than any comparison needs.
pub(crate) fn four_digits(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
