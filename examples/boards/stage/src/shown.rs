//! What the boards show on their displays, as the displays must receive it.

use std::ops::Range;

use super::{CHECKSUM, FRAMES, Stage, checksum};

/// Width and height of the display in pixels.
const SIZE: usize = 240;

/// A picture in the middle of a display of 240 x 240 pixels.
#[derive(Debug)]
pub struct Shown {
    /// The name in the line that the firmware prints, such as `frame 0`.
    pub name: String,
    /// The first and the last column of the window.
    pub columns: [u16; 2],
    /// The first and the last row of the window.
    pub rows: [u16; 2],
    /// RGB565, row by row.
    pub pixels: Vec<u16>,
    /// Whether the stage is drawn and lit: the firmware then marks its parts.
    pub is_lit: bool,
}

impl Shown {
    /// Draws a picture of the sequence that the firmware shows: the still, a black display, the frames
    /// of one swing of the light, and then the same again.
    pub fn numbered(number: u32) -> Self {
        match number % (2 + FRAMES) {
            0 => Self::drawn::<SIZE>("still".to_owned(), 0, -40..200),
            1 => Self::black(),
            number => Self::drawn::<160>(format!("frame {}", number - 2), number - 2, 0..120),
        }
    }

    fn black() -> Self {
        let sides = [0, SIZE as u16 - 1];
        Self {
            name: "black".to_owned(),
            columns: sides,
            rows: sides,
            pixels: vec![0; SIZE * SIZE],
            is_lit: false,
        }
    }

    fn drawn<const WIDTH: usize>(name: String, frame: u32, rows: Range<i32>) -> Self {
        let middle = |size: usize| [(SIZE - size) / 2, (SIZE + size) / 2 - 1].map(|place| place as u16);
        let (columns, lines) = (middle(WIDTH), middle(rows.len()));
        let mut stage = Stage::<WIDTH>::default();
        stage.turn_to(frame);
        let mut row = [0; WIDTH];
        let pixels = rows.flat_map(|number| {
            stage.draw::<()>(number, &mut row);
            row
        });
        Self { name, columns, rows: lines, pixels: pixels.collect(), is_lit: true }
    }

    /// The checksum of the pixels.
    pub fn checksum(&self) -> u32 {
        checksum(CHECKSUM, &self.pixels)
    }
}
