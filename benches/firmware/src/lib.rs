//! Programs that run the kernel on microcontrollers. On the host they compute what the results must
//! be.
#![cfg_attr(target_os = "none", no_std)]

pub mod board;
#[cfg(feature = "export")]
mod exported;
pub mod frame;
mod measure;
pub mod moving;
#[cfg(feature = "pick")]
mod picked;
#[cfg(feature = "effects")]
mod price;

#[cfg(feature = "export")]
pub use exported::exported;
pub use measure::{COUNT, choose, measure, pass};
#[cfg(feature = "pick")]
pub use picked::{Domain, picked};
#[cfg(feature = "effects")]
pub use price::price;
