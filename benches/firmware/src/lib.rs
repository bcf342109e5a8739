//! Programs that run the kernel on microcontrollers. On the host they compute what the results must
//! be.
#![cfg_attr(target_os = "none", no_std)]

pub mod board;
pub mod drawn;
pub mod frame;
mod measure;
#[cfg(feature = "pictures")]
pub mod pictures;
#[cfg(feature = "effects")]
mod price;
#[cfg(feature = "effects")]
mod stack;
#[cfg(feature = "worst")]
pub mod worst;

pub use measure::{COUNT, begin_lines, measure, pass, report, rivals};
#[cfg(feature = "effects")]
pub use price::{choices, evaluations, price};
#[cfg(feature = "effects")]
pub use stack::stack;
