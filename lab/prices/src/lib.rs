//! Measures the error of each kernel, and its time where there is a clock, on the same functions
//! whose instructions the firmware counts.
//!
//! Each measurement is reported as a line of JSON, by a terminal as by a browser. Errors are the same in every run; times are not, and come
//! with their spread.
#![forbid(unsafe_code)]

mod accuracy;
mod site;
mod time;
#[cfg(target_arch = "wasm32")]
mod web;

pub use accuracy::{Accuracy, Errors, Kind, Place};
pub use time::{BATCH, Clock, Times};

use luminaire_kernels::Row;
use serde::Serialize;

/// The name of a kernel in its format.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct Named {
    /// The kernel.
    pub kernel: &'static str,
    /// `falloff`, `lit` and so on.
    pub stage: &'static str,
    /// The number format.
    pub format: &'static str,
}

impl From<Row> for Named {
    fn from(row: Row) -> Self {
        Self { kernel: row.kernel, stage: row.stage.name(), format: row.format }
    }
}
