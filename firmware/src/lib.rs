//! Programs that run the kernel on microcontrollers, and on the host to say what their results must be.
#![cfg_attr(target_os = "none", no_std)]

pub mod board;
pub mod frame;
mod measure;

pub use measure::{COUNT, measure};
