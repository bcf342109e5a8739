//! A picture of the stage in 160 x 120 pixels of RGB565. Each stage of a row runs between markers,
//! so that its instructions are counted separately.

use core::fmt;

use luminaire_stage::{Markers, Stage, Tally};

use crate::board::{begin, end, println};

/// The width of the picture in pixels.
const WIDTH: usize = 160;
/// The height of the picture in pixels.
const HEIGHT: i32 = 120;

/// The markers of the counter.
#[derive(Debug)]
struct Counted;

impl Markers for Counted {
    #[inline(always)]
    fn begin() {
        begin();
    }

    #[inline(always)]
    fn end() {
        end();
    }
}

/// Draws the picture and prints it: its size, the pixels of each row as hexadecimal digits, and how many pixels the light reaches, and why it does not reach the others.
pub fn frame() {
    println!("width {WIDTH} pixels");
    println!("height {HEIGHT} pixels");
    let mut stage = Stage::<WIDTH>::default();
    let mut pixels = [0; WIDTH];
    let mut tally = Tally::default();
    for row in 0..HEIGHT {
        stage.draw::<Counted>(row, &mut pixels);
        stage.add_to(&mut tally);
        println!("row {} digits", Digits(&pixels));
    }
    let [away, outside, shadow, lit] = tally.counts();
    println!(
        "facing-away {away} pixels\noutside {outside} pixels\nin-shadow {shadow} pixels\nlit {lit} pixels"
    );
}

/// Displays pixels as four hexadecimal digits each.
struct Digits<'a>(&'a [u16; WIDTH]);

impl fmt::Display for Digits<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut digits = [b'0'; 4 * WIDTH];
        for (four, pixel) in digits.chunks_exact_mut(4).zip(self.0) {
            for (digit, shift) in four.iter_mut().zip([12, 8, 4, 0]) {
                *digit = b"0123456789abcdef"[usize::from(pixel >> shift & 15)];
            }
        }
        out.write_str(str::from_utf8(&digits).unwrap_or_default())
    }
}
