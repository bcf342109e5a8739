//! Draws a lit wall for ever, and keeps a checksum of its pixels.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use panic_halt as _;
use scanline::scanline;

#[entry]
fn main() -> ! {
    let mut pixels = [0; 160];
    loop {
        let mut checksum = 0_u32;
        for row in 0..120 {
            scanline(row, &mut pixels);
            // Send the row to your display here.
            for pixel in &pixels {
                checksum = checksum.rotate_left(1) ^ u32::from(*pixel);
            }
        }
        black_box(checksum);
    }
}
