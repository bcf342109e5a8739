//! Every kernel with a price, and its rivals, as functions of one input.
//!
//! Firmware, host, browser and demo run the same code, so that the error and the cost in a row
//! belong to the same function. [`falloffs`] and [`points`] pass every row to a [`Visitor`]. On
//! microcontrollers the lit points that are measured are those of a light that is a constant: the crate `luminaire-effects` has them.
//!
//! A falloff maps the angle off axis, in the form that the kernel takes, to an intensity. A point
//! maps a position and a normal to an irradiance. Each kernel gets the exact input rounded to its
//! format, and is compared with the oracle at the exact input: the rounding of the input is part of
//! its error.
//!
//! | format | kernels |
//! |---|---|
//! | `fx16`, `fx32`, `f32` | the crate `luminaire` |
//! | `fx16-quick` | the quick evaluation of the crate `luminaire` |
//! | `f64` | the versine form in twice the width |
//! | `rival` | the methods of others: f32, each with its own formula |
//!
//! Files, in the order in which they build on one another: `value`, `scene`, `truth`, `kernel`, `ours`,
//! `double`, `rival`, `list`.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(feature = "std")]
extern crate std;

mod double;
mod kernel;
mod list;
mod ours;
mod rival;
pub mod scene;
pub mod truth;
mod value;

pub use double::{DoubleFalloff, DoublePoint};
pub use kernel::{Kernel, Row, Stage, Visitor};
pub use list::{Setting, doubles, falloffs, points};
pub use luminaire::falloff::ListedFalloff;
pub use ours::{Highlit, OurFalloff, OurPoint};
#[cfg(feature = "std")]
pub use rival::Std;
pub use rival::{Clamp, CosineFalloff, CosineTable, Gltf, Libm, Micromath, Power, Powf, Schlick, Smoothstep};
pub use value::{Format, Value};

pub use luminaire_oracle as oracle;
