//! Draws a lit wall for ever, and keeps a checksum of its pixels.
#![no_std]
#![no_main]

use core::hint::black_box;

use panic_halt as _;
use scanline::scanline;

#[cfg(target_arch = "arm")]
#[cortex_m_rt::entry]
fn main() -> ! {
    // `entry` makes it a `&mut [u16; 160]`. On the stack it would need code that clears it.
    static mut PIXELS: [u16; 160] = [0; 160];
    draw(PIXELS)
}

#[cfg(target_arch = "riscv32")]
#[riscv_rt::entry]
fn main() -> ! {
    draw(&mut [0; 160])
}

fn draw(pixels: &mut [u16; 160]) -> ! {
    loop {
        let mut checksum = 0_u32;
        for row in 0..120 {
            scanline(row, pixels);
            // Send the row to your display here.
            for pixel in pixels.iter() {
                checksum = checksum.rotate_left(1) ^ u32::from(*pixel);
            }
        }
        black_box(checksum);
    }
}
