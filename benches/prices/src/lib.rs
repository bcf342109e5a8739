//! Measures the error and the time of each kernel: the same functions whose instructions the
//! firmware counts.
//!
//! Each measurement is a line of JSON, on the host as in a browser. Errors are the same in every
//! run. Times vary, and are given with their quartiles.
#![forbid(unsafe_code)]

mod accuracy;
mod ladder;
mod site;
mod time;
#[cfg(target_arch = "wasm32")]
mod web;

pub use accuracy::{Accuracy, Errors, Kind, Place};
pub use ladder::{Rung, Steps};
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
