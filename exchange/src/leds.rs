//! Addressable LEDs at the places of a map.

mod map;
mod placed;

pub use map::LedMap;
pub use placed::{Facing, PlacedLeds, Up};
