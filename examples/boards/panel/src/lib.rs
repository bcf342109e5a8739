//! The stage on an ST7789 display: what the programs of the boards share.
//!
//! [`start`] starts the display, and [`show`] shows a still of 240 x 240 pixels, then a black display,
//! on it frames of 160 x 120 pixels in a window in the middle, and then the still again. A board
//! implements [`Panel`], and counts cycles.
#![cfg_attr(target_os = "none", no_std)]

mod display;
mod picture;
#[cfg(test)]
mod tests;

use core::convert::Infallible;
use core::fmt::Write;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiBus;
use embedded_hal_bus::spi::ExclusiveDevice;
use luminaire_stage::{FRAMES, Markers};
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use mipidsi::options::ColorInversion;

use display::SIZE;
use picture::Picture;

pub use display::{Panel, Row};

/// Starts the display at a bus of bytes in mode 3. `None` if its driver refuses the options.
pub fn start(
    bus: &mut impl SpiBus,
    is_data: &mut impl OutputPin,
    select: &mut impl OutputPin,
    reset: impl OutputPin,
    delay: &mut impl DelayNs,
) -> Option<()> {
    let device = ExclusiveDevice::new_no_delay(bus, select).ok()?;
    let mut buffer = [0; 16];
    let started = Builder::new(ST7789, SpiInterface::new(device, is_data, &mut buffer))
        .display_size(SIZE, SIZE)
        .invert_colors(ColorInversion::Inverted)
        .reset_pin(reset)
        .init(delay);
    started.ok().map(drop)
}

/// The rows that are drawn and sent: two of each picture.
#[derive(Debug)]
pub struct Rows {
    still: [[u16; 240]; 2],
    moving: [[u16; 160]; 2],
}

impl Rows {
    /// Black rows.
    pub const BLACK: Self = Self { still: [[0; 240]; 2], moving: [[0; 160]; 2] };
}

/// Shows the pictures for ever, and prints a line after each. `now` counts cycles modulo 2^24 or a
/// larger power of two.
pub fn show<M: Markers>(
    panel: &mut impl Panel,
    rows: &'static mut Rows,
    now: impl Fn() -> u32,
    out: &mut impl Write,
) -> Option<Infallible> {
    let mut still = Picture::new(&mut rows.still);
    let mut moving = Picture::new(&mut rows.moving);
    loop {
        let report = still.draw::<M>(0, -40..200, panel, &now)?;
        writeln!(out, "still: {report}\r").ok()?;
        writeln!(out, "black: {}\r", still.blacken(panel)?).ok()?;
        for frame in 0..FRAMES {
            let report = moving.draw::<M>(frame, 0..120, panel, &now)?;
            writeln!(out, "frame {frame}: {report}\r").ok()?;
        }
    }
}
