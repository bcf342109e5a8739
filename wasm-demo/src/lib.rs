//! The browser demo: a thin layer over `luminaire-render` and `luminaire-kernels`, and a page that
//! shows their results.
//!
//! The page contains no lighting mathematics and no state of the picture. It passes the visitor's
//! settings to these classes and gets everything that it displays from them. [`Stage`] has a scene
//! under the visitor's settings, and lists the effects that the scene needs. [`Painter`] draws a
//! share of its picture, mostly in a worker, and counts the skipped work. [`Comparison`] lights one
//! wall in two forms and measures the error of each against f64. [`Museum`] shows faulty spotlights
//! of other projects. [`Class`] draws figures that teach spotlights.
//!
//! The features are parts of the crate. The packages of `modules` compile each as a WebAssembly module
//! of its own, so that the first picture waits only for what it needs:
//!
//! - `stage`: the stage and the painters of pictures in 16 bits
//! - `wide`: the painters of pictures in 32 bits, fixed and float, loaded with the first such picture
//! - `comparison`: the comparison and the museum, loaded when one of them is first requested
//! - `class`: the figures that teach spotlights, loaded when the class is first requested
//! - `code`: the exporter of lights, loaded when its drawer is opened
//! - `files`: the readers of lights of other tools, loaded with the first file
#![forbid(unsafe_code)]
#![cfg_attr(
    not(feature = "default"),
    allow(dead_code, unused_imports, unused_macros, reason = "each part uses some of what they share")
)]

#[cfg(feature = "stage")]
mod add;
#[cfg(feature = "state")]
mod address;
#[cfg(feature = "stage")]
mod aim;
#[cfg(feature = "comparison")]
mod canvas;
#[cfg(feature = "class")]
mod class;
mod clock;
#[cfg(feature = "code")]
mod code;
#[cfg(feature = "comparison")]
mod comparison;
#[cfg(feature = "stage")]
mod composite;
#[cfg(feature = "stage")]
mod curve;
#[cfg(feature = "state")]
mod decimal;
#[cfg(feature = "state")]
mod design;
#[cfg(feature = "stage")]
mod dial;
#[cfg(feature = "comparison")]
mod difference;
mod display;
#[cfg(feature = "stage")]
mod divided;
#[cfg(feature = "painter")]
mod equality;
mod false_colour;
#[cfg(feature = "files")]
mod file;
#[cfg(feature = "state")]
mod fixture;
#[cfg(feature = "comparison")]
mod form;
#[cfg(feature = "state")]
mod format;
#[cfg(feature = "state")]
mod job;
#[cfg(feature = "state")]
mod kind;
#[cfg(feature = "state")]
mod leds;
#[cfg(feature = "state")]
mod light;
#[cfg(feature = "state")]
mod map;
#[cfg(feature = "state")]
mod model;
#[cfg(feature = "comparison")]
mod museum;
#[cfg(feature = "state")]
mod name;
#[cfg(feature = "state")]
mod own_cone;
#[cfg(feature = "painter")]
mod painter;
mod panic;
#[cfg(feature = "state")]
mod parameter;
#[cfg(feature = "stage")]
mod photometry;
#[cfg(feature = "comparison")]
mod picture;
mod plain;
mod quantity;
mod refusal;
#[cfg(feature = "state")]
mod rig;
#[cfg(feature = "state")]
mod scene_state;
#[cfg(feature = "state")]
mod setting;
#[cfg(feature = "comparison")]
mod side;
#[cfg(feature = "stage")]
mod stage;
#[cfg(feature = "state")]
mod state;
#[cfg(feature = "state")]
mod viewpoint;
#[cfg(feature = "comparison")]
mod wall;

#[cfg(feature = "class")]
pub use class::Class;
#[cfg(feature = "code")]
pub use code::Code;
#[cfg(feature = "comparison")]
pub use comparison::Comparison;
#[cfg(feature = "stage")]
pub use composite::Composite;
#[cfg(feature = "stage")]
pub use divided::Divided;
#[cfg(feature = "files")]
pub use file::{LedFile, LightFile};
#[cfg(feature = "state")]
pub use light::{DialEnds, LightState};
#[cfg(feature = "comparison")]
pub use museum::Museum;
pub use refusal::Refusal;
#[cfg(feature = "comparison")]
pub use side::SideState;
#[cfg(feature = "stage")]
pub use stage::Stage;
#[cfg(feature = "painter")]
pub use {
    equality::Equality,
    painter::{Painter, Times},
};
