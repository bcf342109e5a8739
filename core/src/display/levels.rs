//! Levels of tables: the channels of a pixel with fraction bits, in 32 bits. A dithered pixel is then
//! a sum with the offset of its place, without the fractions.

use core::marker::PhantomData;

use super::{dither, pixel::Sealed};
use crate::color::Rgb;

/// The layout of a level: green in the upper bits, blue in the lower bits, red between them.
struct Layout<P>(PhantomData<P>);

impl<P: Sealed> Layout<P> {
    /// The lowest bit of red. Where there is room, one shift brings the codes of red and blue to their
    /// places in a pixel, as in RGB565; else red is next to blue.
    const RED: u32 = {
        let Rgb { red, green, blue } = P::WIDTHS;
        let (aligned, near) = (green + blue, blue + P::FRACTION);
        let fits = aligned >= near && aligned + red + 2 * P::FRACTION + green <= 32;
        if fits { aligned } else { near }
    };
    /// The lowest bit of green.
    const GREEN: u32 = 32 - P::WIDTHS.green - P::FRACTION;
    /// What is added to a level before its fractions are cut off: thresholds are odd numbers of 128ths,
    /// so the offsets are `2^FRACTION - 1` for the first to 0 for the last.
    const OFFSETS: [[u32; 8]; 8] = {
        let mut offsets = [[0; 8]; 8];
        let mut place = 0;
        while place < 64 {
            let (x, y) = (place % 8, place / 8);
            let offset = (127 - dither::MATRIX[y][x] as u32) >> (7 - P::FRACTION);
            offsets[y][x] = packed_channels::<P>(Rgb::new(offset, offset, offset));
            place += 1;
        }
        offsets
    };
}

/// Returns channels in steps with fraction bits as a level.
const fn packed_channels<P: Sealed>(steps: Rgb<u32>) -> u32 {
    steps.green << Layout::<P>::GREEN | steps.red << Layout::<P>::RED | steps.blue
}

/// Returns the level of a linear colour clipped to `[0, 1]`.
pub(crate) fn packed<P: Sealed>(color: Rgb<f32>) -> u32 {
    packed_channels::<P>(P::steps(color))
}

/// Returns the offsets of the pixels of a row, by the last three bits of x.
#[inline(always)]
pub(crate) fn offsets<P: Sealed>(y: u32) -> &'static [u32; 8] {
    &Layout::<P>::OFFSETS[(y % 8) as usize]
}

/// Returns the pixel of a level with an offset.
///
/// The channels do not overflow into each other: with the largest offset a channel is at most its last
/// code and a fraction, because the last code has no fraction.
#[inline(always)]
pub(crate) fn shown<P: Sealed>(level: u32, offset: u32) -> P {
    let Rgb { red, green, blue } = P::WIDTHS;
    let sum = level.wrapping_add(offset);
    let reds = (sum >> (Layout::<P>::RED + P::FRACTION) & ((1 << red) - 1)) << (green + blue);
    P::of_bits(reds | sum >> (32 - green) << blue | sum >> P::FRACTION & ((1 << blue) - 1))
}
