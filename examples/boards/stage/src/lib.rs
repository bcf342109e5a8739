//! A stage lit pixel by pixel in 16 bits: a wall, a floor, a ball and a column under a soft
//! spotlight that moves, in pixels of RGB565.
//!
//! [`Stage`] draws row after row into a buffer of the caller, without floats, and with memory for
//! one row only. Each row goes through the same [stages of computation](STAGES). Before and after
//! each of them the program is called, so that it can count instructions.
#![cfg_attr(target_os = "none", no_std)]

mod backdrop;
mod ball;
mod camera;
mod column;
#[cfg_attr(not(test), allow(dead_code, reason = "the build script compiles the light and the materials"))]
mod measures;
mod paint;
mod path;
mod quadratic;
mod scene;
mod shadow;
#[cfg(not(target_os = "none"))]
mod shown;
mod site;
mod tally;
#[cfg(test)]
mod tests;
mod way;

use luminaire::number::Light16;

use backdrop::Seen;
use column::Side;
use paint::{Ambient, Key};
use site::Site;

pub use path::FRAMES;
#[cfg(not(target_os = "none"))]
pub use shown::Shown;
pub use tally::Tally;

/// The stages of a row, in the order in which they run.
pub const STAGES: &str = "geometry shadow light display";

/// What a program does before and after each stage of a row, such as marking it for a counter of
/// instructions.
pub trait Markers: core::fmt::Debug {
    /// Called before a stage.
    fn begin();
    /// Called after a stage.
    fn end();
}

/// Does nothing.
impl Markers for () {
    fn begin() {}
    fn end() {}
}

/// The stage in a picture of `WIDTH` pixels, with the buffers of a row.
#[derive(Debug)]
pub struct Stage<const WIDTH: usize> {
    key: Key,
    side: Side,
    ambient: Ambient,
    sites: [Site; WIDTH],
    lights: [Light16; WIDTH],
    seen: Seen,
}

impl<const WIDTH: usize> Default for Stage<WIDTH> {
    fn default() -> Self {
        Self {
            key: paint::KEY,
            side: Side::new::<WIDTH>(),
            ambient: Ambient::new(),
            sites: [Site::default(); WIDTH],
            lights: [Light16::ZERO; WIDTH],
            seen: Seen::new::<WIDTH>(),
        }
    }
}

impl<const WIDTH: usize> Stage<WIDTH> {
    /// Aims the spotlight where it points in a frame of its movement.
    ///
    /// In frame 0, and in every multiple of [`FRAMES`], the axis is that of the recorded
    /// picture.
    pub fn turn_to(&mut self, frame: u32) {
        self.key = path::aimed(paint::KEY, frame);
    }

    /// Draws a row into a buffer of RGB565. Row 0 is the top row of the recorded picture, and rows
    /// above it have negative numbers.
    pub fn draw<M: Markers>(&mut self, row: i32, pixels: &mut [u16; WIDTH]) {
        let Self { key, side, ambient, sites, lights, seen } = self;
        run::<M>(|| scene::look(seen, side, row, sites));
        run::<M>(|| shadow::cast(seen, sites, lights));
        run::<M>(|| paint::light(key, seen, sites, lights));
        run::<M>(|| paint::display((seen, lights), (row, ambient), pixels));
    }

    /// Adds the pixels of the row that was drawn last to a tally.
    pub fn add_to(&self, tally: &mut Tally) {
        tally.add(&self.key, &self.seen.sites(&self.sites), &self.seen.lights(&self.lights));
    }
}

/// The checksum of no pixels.
pub const CHECKSUM: u32 = 0x811c_9dc5;

/// Adds pixels to a checksum: the hash FNV-1a over words of 16 bits.
pub fn checksum(sum: u32, pixels: &[u16]) -> u32 {
    pixels.iter().fold(sum, |sum, pixel| (sum ^ u32::from(*pixel)).wrapping_mul(16_777_619))
}

/// Runs a stage between the markers.
#[inline(always)]
fn run<M: Markers>(stage: impl FnOnce()) {
    M::begin();
    stage();
    M::end();
}
