//! An orange LED of four families in a dim room: prints its bytes, and the hue that a thousandth of the light keeps.
//!
//! In `Fx16` a thousandth of full scale has 16 steps. A light that is dimmed to it loses its hue; a strip that is dimmed
//! keeps it, because it multiplies with more bits, and temporal dither shows what is between two duties.

use luminaire::{
    Fx16, Rgb,
    display::{Apa102, Hd108, LedChip, LedOrder, LedStrip, Rgbw},
};

/// Half as much green as red.
const ORANGE: Rgb<f32> = Rgb::new(0.93, 0.465, 0.1);
const DIM: f32 = 0.001;
const FRAMES: u32 = 50_000;

fn main() {
    println!("{:<12} {:<24} {:>15} {:>15}", "chip", "bytes", "of a dim light", "of a dim strip");
    row("WS2812", LedOrder::Grb, |led| [led[1], led[0]].map(f64::from));
    row("SK6812 RGBW", Rgbw(LedOrder::Grb), |led| {
        [led[1], led[0]].map(|duty| f64::from(duty) + f64::from(led[3]))
    });
    // Duties, by the current of the first byte.
    row("APA102", Apa102(LedOrder::Bgr), |led| {
        [led[3], led[2]].map(|duty| f64::from(duty) * f64::from(led[0] & 31))
    });
    row("HD108", Hd108(LedOrder::Rgb), |led| {
        [2, 4].map(|at| f64::from(u16::from_be_bytes([led[at], led[at + 1]])))
    });
}

/// Prints the row of a chip, whose bytes show this much red and green.
fn row<C: LedChip>(name: &str, chip: C, shown: fn(&[u8]) -> [f64; 2]) {
    let strip = LedStrip::new(chip);
    let (_, bytes) = mean(strip, ORANGE, 1, shown);
    let (light, _) = mean(strip, ORANGE.map(|channel| channel * DIM), FRAMES, shown);
    let (dimmed, _) = mean(strip.with_brightness(DIM), ORANGE, FRAMES, shown);
    let bytes: Vec<_> = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
    println!("{name:<12} {:<24} {light:>15.3} {dimmed:>15.3}", bytes.join(" "));
}

/// Returns the ratio of green to red over frames, and the bytes of the last.
fn mean<C: LedChip>(
    strip: LedStrip<C>,
    light: Rgb<f32>,
    frames: u32,
    shown: fn(&[u8]) -> [f64; 2],
) -> (f64, Vec<u8>) {
    let (mut dithers, mut bytes) = ([C::dither(0)], vec![0; C::BYTES]);
    let (mut red, mut green) = (0.0, 0.0);
    for _ in 0..frames {
        strip.write(&[light.map(Fx16::from_f32)], &mut dithers, &mut bytes);
        let [more_red, more_green] = shown(&bytes);
        (red, green) = (red + more_red, green + more_green);
    }
    (green / red, bytes)
}
