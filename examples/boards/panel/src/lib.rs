//! The stage on an ST7789 display: what the programs of the boards share.
//!
//! [`start`] starts the display, and [`show`] shows a still of 240 x 240 pixels, then a black display,
//! on it frames of 160 x 120 pixels in a window in the middle, and then the still again. A board
//! implements [`Panel`], may have a [`Second`] core, and counts cycles.
#![cfg_attr(target_os = "none", no_std)]

mod display;
mod picture;
mod second;

use core::convert::Infallible;
use core::fmt::Write;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiDevice;
use luminaire_stage::{FRAMES, Markers};
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use mipidsi::options::ColorInversion;

use display::SIZE;
use picture::Picture;
use second::Drawn;

pub use display::{Panel, Words};
pub use second::{Job, Second, Strip};

/// Starts the display at a bus of bytes in mode 3, which selects it. `None` if its driver refuses the options.
pub fn start(
    bus: impl SpiDevice,
    is_data: &mut impl OutputPin,
    reset: impl OutputPin,
    delay: &mut impl DelayNs,
) -> Option<()> {
    let mut buffer = [0; 16];
    let started = Builder::new(ST7789, SpiInterface::new(bus, is_data, &mut buffer))
        .display_size(SIZE, SIZE)
        .invert_colors(ColorInversion::Inverted)
        .reset_pin(reset)
        .init(delay);
    started.ok().map(drop)
}

/// The rows that are drawn and sent: two pairs of each picture, and one row of each that the second core draws.
#[derive(Debug)]
pub struct Rows<M> {
    still: [[u16; 480]; 2],
    moving: [[u16; 320]; 2],
    still_strip: Drawn<240, M>,
    moving_strip: Drawn<160, M>,
}

impl<M> Default for Rows<M> {
    fn default() -> Self {
        let (still, moving) = ([[0; 480]; 2], [[0; 320]; 2]);
        Self { still, moving, still_strip: Drawn::default(), moving_strip: Drawn::default() }
    }
}

/// Shows the pictures for ever, and prints a line after each. `now` counts cycles modulo 2^24 or a
/// larger power of two.
pub fn show<M: Markers>(
    panel: &mut impl Panel,
    second: &mut impl Second,
    rows: &'static mut Rows<M>,
    now: impl Fn() -> u32,
    out: &mut impl Write,
) -> Option<Infallible> {
    let mut still = Picture::<240, 480>::new(&mut rows.still, &mut rows.still_strip);
    let mut moving = Picture::<160, 320>::new(&mut rows.moving, &mut rows.moving_strip);
    loop {
        let report = still.draw::<M>(0, -40..200, panel, second, &now)?;
        writeln!(out, "still: {report}\r").ok()?;
        writeln!(out, "black: {}\r", still.blacken(panel)?).ok()?;
        for frame in 0..FRAMES {
            let report = moving.draw::<M>(frame, 0..120, panel, second, &now)?;
            writeln!(out, "frame {frame}: {report}\r").ok()?;
        }
    }
}
