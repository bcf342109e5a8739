//! Every kernel that has a price, and what a user would take instead, as functions of one input.
//!
//! Firmware, host, browser and demo run this same code, so that an error and a cost that stand in
//! one line belong to one function. [`falloffs`] and [`points`] are the list; who walks it brings a
//! [`Visitor`].
//!
//! A falloff goes from the angle off axis, in the form that the kernel takes, to an intensity. A
//! point goes from a place and a normal to the light that arrives. Each kernel is given the nearest
//! input that its format has, and is compared with the oracle's answer to the exact one: what a
//! format loses of its input is part of its error.
//!
//! | format | what it is |
//! |---|---|
//! | `fx16`, `fx32`, `f32` | the crate `luminaire` |
//! | `f32-cosine` | f32, with the versine by `1 - l.s`, which cancels |
//! | `f32-fast` | f32, with micromath's guess of the reciprocal root as it is |
//! | `f64` | the versine form in twice the width |
//! | `rival` | what others do: f32, and a formula of its own |
//!
//! Files, in the order in which they build on one another: `value`, `oracle`, `profile`, `scene`,
//! `kernel`, `ours`, `cosine`, `fast`, `double`, `rival`, `list`.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(feature = "std")]
extern crate std;

mod cosine;
mod double;
mod fast;
mod kernel;
mod list;
pub mod oracle;
mod ours;
mod profile;
mod rival;
pub mod scene;
mod value;

pub use cosine::{CosineFalloff, CosinePoint};
pub use double::{DoubleFalloff, DoublePoint};
pub use fast::FastPoint;
pub use kernel::{Kernel, Row, Stage, Visitor};
pub use list::{Setting, falloffs, points};
pub use ours::{Highlit, OurFalloff, OurPoint};
pub use profile::Shape;
#[cfg(feature = "std")]
pub use rival::Std;
pub use rival::{Clamp, CosineTable, Gltf, Libm, Micromath, Power, Powf, Schlick, Smoothstep};
pub use value::{Format, Value};
