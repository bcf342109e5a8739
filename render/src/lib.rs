//! A small deferred software renderer for the lights of [`luminaire`]: `no_std` + `alloc`, without
//! a GPU.
//!
//! ```
//! use luminaire_render::{Renderer, scenes::stage};
//! let mut renderer = Renderer::<f32>::new(320, 180)?;
//! renderer.draw_geometry(&stage::scene()?, &stage::camera());
//! renderer.draw_light(&stage::lights()?)?;
//! let pixels = renderer.encode(); // red, green, blue, alpha; sRGB
//! assert!(pixels.chunks_exact(4).any(|pixel| pixel[0] > 200));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A picture takes four passes. Each pass is repeated only where its input has changed:
//!
//! 1. [`draw_geometry`](Renderer::draw_geometry) draws the [`Scene`] from a [`Camera`] into the
//!    G-buffer: position, normal and material of each pixel, in the number format of the light.
//! 2. [`draw_shadows`](Renderer::draw_shadows) draws a [`ShadowMap`] for each fixture with shadows.
//! 3. [`draw_light`](Renderer::draw_light) adds up the light of the fixtures over the G-buffer, in
//!    blocks of 32 pixels as structures of arrays. Only tiles that a changed fixture reaches now or
//!    reached before the change are re-lit. Within a re-lit tile, each light skips the blocks that
//!    the light cannot reach.
//! 4. [`encode`](Renderer::encode) encodes the re-lit tiles for a [`Display`]. With
//!    [`set_antialiased`](Renderer::set_antialiased) it also mixes the pixels beside visible
//!    [`Edges`] of meshes.
//!
//! **Only the effects that a scene needs are computed.** The kind, falloff and attenuation of a
//! light select a loop, once for each block. Highlights are computed only for shiny materials,
//! gobos and shadows only for fixtures that have them, and beams only in haze. Skipping never
//! changes the result: [`draw_everything`](Renderer::draw_everything) skips nothing, and the
//! picture is bit-identical. The [`Account`] counts the skipped work.
//!
//! The number format is the renderer's type parameter: `f32`, [`Fx32`](luminaire::Fx32) or
//! [`Fx16`](luminaire::Fx16). Irradiance, gobos, shadows, highlights, colours, the sums of lights, hue, dither
//! and codes are computed in the format, by the kernel's operations. The camera, the triangles, the set-up of
//! lights, haze and [`Edges`] are in `f32` in every format. [`stated_error`] returns how much the pictures in
//! these formats differ.
//!
//! The feature `std` takes the square root from the standard library instead of `libm`. The results
//! are bit-identical. On most targets rendering with `std` is several times faster, because
//! compilers vectorise the loops only with the square root of the standard library.

// Modules, lowest first: `size`, `stripes`, `error`, `buffer`, `space`, `scene`, `raster`, `shadow`,
// `light`, `renderer`, `scenes`.

#![no_std]
#![forbid(unsafe_code)]

extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

mod buffer;
mod error;
mod light;
mod raster;
mod renderer;
mod scene;
pub mod scenes;
mod shadow;
mod size;
mod space;
mod stripes;

pub use buffer::LANES;
pub use error::DrawError;
pub use renderer::{
    Renderer,
    account::Account,
    display::{ACEP, Display, Output},
    edges::Edges,
    format::{Format, stated_error},
};
pub use scene::{
    Highlight, Material, Scene, camera::Camera, mesh::Mesh, outline::Outline, strip::Strip,
    surfaces::Surfaces,
};
pub use shadow::map::ShadowMap;
pub use size::{LARGEST, SizeError};
pub use stripes::Stripes;

/// The README's example is a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
