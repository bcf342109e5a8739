//! A picture lit pixel by pixel in 16 bits: a wall, a floor, a ball and a column under a soft
//! spotlight, in 160 x 120 pixels of RGB565. The program uses no floats, and memory for one row
//! only.
//!
//! Each row goes through the same stages. Each stage runs between markers, so that its instructions
//! are counted separately.

mod ball;
mod camera;
mod column;
#[cfg_attr(not(test), allow(dead_code, reason = "the build script compiles the light and the materials"))]
mod measures;
mod paint;
mod quadratic;
mod scene;
mod shadow;
mod tally;
#[cfg(test)]
mod tests;

use core::fmt;

use luminaire::{display::Rgb565, number::Light16};

use crate::board::{begin, end, println};
use paint::{Ambient, Color};
use scene::Site;
use tally::Tally;

/// The width of the picture in pixels.
const WIDTH: usize = 160;
/// The height of the picture in pixels.
const HEIGHT: usize = 120;
/// The stages of a row, in the order in which they are counted.
const STAGES: &str = "geometry ambient light shadow colour display";

/// The buffers of a row, which the stages fill one after the other.
struct Row {
    sites: [Site; WIDTH],
    lights: [Light16; WIDTH],
    colors: [Color; WIDTH],
    pixels: [Rgb565; WIDTH],
}

/// Draws the picture and prints it. The first line states its size and the stages. Then come the
/// pixels of each row, as hexadecimal digits. The last line states how many pixels the light
/// reaches, and why it does not reach the others.
pub fn frame() {
    println!("{WIDTH} {HEIGHT} {STAGES}");
    let mut row = Row::new();
    let ambient = Ambient::new();
    let mut tally = Tally::default();
    for number in 0..HEIGHT {
        row.draw(number, &ambient);
        tally.add(&row.sites);
        println!("{}", Digits(&row.pixels));
    }
    println!("{tally}");
}

impl Row {
    fn new() -> Self {
        Self {
            sites: [Site::default(); WIDTH],
            lights: [Light16::ZERO; WIDTH],
            colors: [Color::default(); WIDTH],
            pixels: [Rgb565::default(); WIDTH],
        }
    }

    fn draw(&mut self, number: usize, ambient: &Ambient) {
        count(|| scene::look(number, &mut self.sites));
        // A picture without the spotlight ends here.
        count(|| ambient.paint(&self.sites, number, &mut self.pixels));
        count(|| paint::light(&self.sites, &mut self.lights));
        count(|| shadow::cast(&self.sites, &mut self.lights));
        count(|| paint::color(&self.sites, &self.lights, &mut self.colors));
        count(|| paint::display(&self.lights, &self.colors, number, &mut self.pixels));
    }
}

/// Runs a stage between the markers.
#[inline(always)]
fn count(stage: impl FnOnce()) {
    begin();
    stage();
    end();
}

/// Displays pixels as four hexadecimal digits each.
struct Digits<'a>(&'a [Rgb565; WIDTH]);

impl fmt::Display for Digits<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut digits = [b'0'; 4 * WIDTH];
        for (four, pixel) in digits.chunks_exact_mut(4).zip(self.0) {
            for (digit, shift) in four.iter_mut().zip([12, 8, 4, 0]) {
                *digit = b"0123456789abcdef"[usize::from(pixel.0 >> shift & 15)];
            }
        }
        out.write_str(str::from_utf8(&digits).unwrap_or_default())
    }
}
