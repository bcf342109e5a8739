//! Lights from the files and the numbers of other tools, and parameters of a light for other tools.
#![forbid(unsafe_code)]

mod curve;
mod lamp;
mod read;
mod record;
mod refusal;
mod sheet;
mod text;

pub use crate::curve::{Curve, Definition};
pub use crate::lamp::{Lamp, Lamps};
pub use crate::refusal::Refusal;
pub use crate::sheet::{Edge, Sheet, fixture};
