//! A small deferred software renderer, `no_std` + `alloc`.
#![no_std]
#![forbid(unsafe_code)]

extern crate alloc;

mod bounds;
mod camera;
mod clip;
mod display;
mod format;
mod gbuffer;
mod lighting;
mod memory;
mod mesh;
mod outline;
mod raster;
mod renderer;
mod scene;
mod size;
pub mod stage;
mod view;

pub use camera::Camera;
pub use format::{Format, stated_error};
pub use mesh::Mesh;
pub use outline::Outline;
pub use renderer::Renderer;
pub use scene::{Material, Scene};
pub use size::{LARGEST, SizeError};
