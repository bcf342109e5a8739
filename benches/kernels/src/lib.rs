//! Every kernel with a price, and its rivals, as functions of one input.
//!
//! Firmware, host, browser and demo run the same code, so that the error and the cost in a row
//! belong to the same function. [`falloffs`], [`points`] and [`rivals`] pass every row to a [`Visitor`]. On
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
//! | `rival` | the methods of others, each with its own formula: falloffs in f32, [lit points](rivals) in fixed point and f32 |
//!
//! Files, in the order in which they build on one another: `value`, `scene`, `truth`, `kernel`, `ours`,
//! `double`, `rival`, `list`, `others`.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(feature = "std")]
extern crate std;

mod double;
mod kernel;
mod list;
mod others;
mod ours;
mod rival;
pub mod scene;
pub mod truth;
mod value;

pub use double::{DoubleFalloff, DoublePoint};
pub use kernel::{Kernel, Row, Stage, Visitor};
pub use list::{Setting, doubles, falloffs, points};
pub use luminaire::falloff::ListedFalloff;
pub use others::{RivalVisitor, rivals};
pub use ours::{Highlit, OurFalloff, OurPoint};
#[cfg(feature = "std")]
pub use rival::Std;
pub use rival::{CosineFalloff, CosineTable, Gltf, Law, Libm, Power, Powf, RANGE, Rival};
pub use value::{Format, Green, Q16, Value};

pub use luminaire_oracle as oracle;
