//! Picks the cheapest evaluation of a light whose error is small enough for a display.
//!
//! A build script describes the chip, the display and the light. The answer contains the
//! evaluation, the price and an error bound of the evaluation, and the constant to compile into the
//! firmware:
//!
//! ```
//! use luminaire_pick::{Chip, Display, Light, Request};
//! let light = Light { field: Some(30.0), near: 2.0, far: 9.0, ..Light::default() };
//! let answer = Request::new(Chip::CortexM0, Display::Rgb565).steps(1.0).pick(&light)?;
//! assert!(answer.bound.value <= 1.0);
//! assert!(answer.code.contains("pub const LIGHT: "));
//! # Ok::<(), luminaire_pick::Refusal>(())
//! ```
//!
//! A light is a spotlight by its angles, or any light that the kernel compiles: [`Light::of`]. The error bound is
//! derived when `pick` is called: see [`Bound`]. The prices are counted under
//! an emulator: see [`Price`]. Several lights can share a tolerance: see [`Scene`].
//!
//! Files, in the order in which they build on one another: `target`, `part`, `refusal`, `light`,
//! `truth`, `evaluation`, `search`, `price`, `request`, `survey`, `scene`, `farther`, `measure`.
#![forbid(unsafe_code)]

mod evaluation;
mod farther;
mod light;
#[doc(hidden)]
pub mod measure;
mod part;
mod price;
mod refusal;
mod request;
mod scene;
mod search;
mod survey;
mod target;
mod truth;

pub use evaluation::Evaluation;
pub use farther::Farther;
pub use light::{Attenuation, Edge, Light};
pub use price::{Counted, Price};
pub use refusal::Refusal;
pub use request::{Answer, Cheaper, Request};
pub use scene::{Budget, Scene, SceneAnswer};
pub use search::{Bound, Place};
pub use survey::{Survey, Surveyed};
pub use target::{Chip, Display, Tolerance};
