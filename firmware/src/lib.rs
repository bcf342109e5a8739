//! Programs that run the kernel on microcontrollers, and on the host to say what their results must be.
#![cfg_attr(target_os = "none", no_std)]

pub mod board;
mod checksum;
mod measure;
pub mod scene;

pub use checksum::Bits;
pub use measure::Inputs;
