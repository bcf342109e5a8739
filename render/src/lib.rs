//! A small deferred software renderer for the lights of [`luminaire`]: `no_std` + `alloc`, without a GPU.
//!
//! ```
//! use luminaire_render::{Renderer, stage};
//! let mut renderer = Renderer::<f32>::new(320, 180)?;
//! renderer.draw_geometry(&stage::scene(), &stage::camera());
//! renderer.draw_light(&stage::lights()?)?;
//! let pixels = renderer.encode(); // red, green, blue, alpha; sRGB
//! assert!(pixels.chunks_exact(4).any(|pixel| pixel[0] > 200));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A picture is made in three passes, and each is made again only if something before it has changed:
//!
//! 1. [`draw_geometry`](Renderer::draw_geometry) draws the [`Scene`] from a [`Camera`] into the G-buffer:
//!    position, normal and material of each pixel, already in the number format of the light.
//! 2. [`draw_light`](Renderer::draw_light) adds up the light of the spots over that buffer, in blocks of
//!    pixels with each quantity in an array of its own. A block that a beam cannot reach is left out.
//! 3. [`encode`](Renderer::encode) makes sRGB codes of it.
//!
//! The [`examples`] are scenes that differ in what they call for.
//!
//! The number format is the renderer's type parameter: `f32`, [`Fx32`](luminaire::Fx32) or
//! [`Fx16`](luminaire::Fx16); [`stated_error`] says how far the pictures differ. There are no shadows and no
//! highlights: the light is the kernel's, falloff, inverse-square distance and Lambert's cosine.
//!
//! The feature `std` takes the square root from the standard library in place of `libm`: the same bits, and
//! on most targets several times quicker, because only then the loops become vector instructions.
#![no_std]
#![forbid(unsafe_code)]

extern crate alloc;

mod account;
mod air;
mod bounds;
mod camera;
mod clip;
mod display;
mod error;
pub mod examples;
mod format;
mod gbuffer;
pub mod gobos;
mod lighting;
mod memory;
mod mesh;
mod outline;
mod raster;
mod reached;
mod renderer;
mod scene;
mod shadow_map;
mod shadows;
mod size;
mod solids;
pub mod stage;
mod tile;
mod view;

pub use account::Account;
pub use camera::Camera;
pub use display::Display;
pub use error::DrawError;
pub use format::{Format, stated_error};
pub use mesh::Mesh;
pub use outline::Outline;
pub use renderer::Renderer;
pub use scene::{Highlight, Material, Scene};
pub use shadow_map::ShadowMap;
pub use size::{LARGEST, SizeError};
