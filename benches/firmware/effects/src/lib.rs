//! Effects: functions of one input, with constants for lights and surfaces. The programs that
//! contain one effect each share their input, their output, and a panic handler that cannot be
//! linked.
#![cfg_attr(target_os = "none", no_std)]

#[macro_use]
mod catalogue;
pub mod constants;
pub mod effects;
mod format;
mod input;
mod listed;
#[path = "../../no_panic.rs"]
mod no_panic;
mod output;

pub use catalogue::{Entry, Visit};
pub use effects::{each, each_choice, each_evaluation};
pub use format::{Color, Format, Irradiance, Light, Surface};
pub use input::{Input, Inputs, Place, run};
pub use listed::Listed;
pub use output::Output;

/// Makes a program of an effect, a function of one [`Input`], which does not link if it can panic.
#[macro_export]
macro_rules! program {
    ($effect:expr) => {
        $crate::without_panic!($crate::run($effect));
    };
}
