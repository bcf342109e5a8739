//! Programs that run the kernel on microcontrollers, and on the host to say what their results must
//! be.
#![cfg_attr(target_os = "none", no_std)]

pub mod board;
pub mod frame;
mod measure;
#[cfg(feature = "effects")]
mod price;

pub use measure::{COUNT, measure};
#[cfg(feature = "effects")]
pub use price::price;
