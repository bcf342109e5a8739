//! Lights from the files and the numbers of other tools, and parameters of a light for other tools; and places of LEDs.
#![forbid(unsafe_code)]

mod about;
mod convert;
mod curve;
mod difference;
mod family;
mod fit;
mod input;
mod lamp;
pub mod leds;
mod limits;
mod measured;
mod parameters;
mod profile;
mod read;
mod reading;
mod record;
mod refusal;
mod residual;
mod search;
mod sheet;
mod sphere;
mod system;
mod tabulate;
mod text;
mod tool;
mod versine;
pub mod write;

pub use crate::curve::{Curve, Definition};
pub use crate::difference::Difference;
pub use crate::fit::{Fit, fits, share};
pub use crate::input::{largest, numbers, read, read_beside};
pub use crate::lamp::{Lamp, Lamps, Patched, Place, Use, placed};
pub use crate::parameters::{Parameters, parameters};
pub use crate::profile::Beside;
pub use crate::reading::Reading;
pub use crate::refusal::Refusal;
pub use crate::residual::Residual;
pub use crate::sheet::{Edge, Sheet, fixture, number};
pub use crate::system::System;
