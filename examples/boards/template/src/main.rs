//! Draws a lit wall for ever, and keeps a checksum of its pixels.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use panic_halt as _;
use scanline::scanline;

#[entry]
fn main() -> ! {
    // `entry` makes it a `&mut [u16; 160]`. On the stack it would need code that clears it.
    static mut PIXELS: [u16; 160] = [0; 160];
    loop {
        let mut checksum = 0_u32;
        for row in 0..120 {
            scanline(row, PIXELS);
            // Send the row to your display here.
            for pixel in PIXELS.iter() {
                checksum = checksum.rotate_left(1) ^ u32::from(*pixel);
            }
        }
        black_box(checksum);
    }
}
