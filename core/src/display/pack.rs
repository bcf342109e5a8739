//! Pixels packed to the bytes of a display.

use super::pixel::Pixel;

/// The order of bits in packed bytes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Layout {
    /// Most significant bit first (big endian): the upper byte of a pixel comes first, and the first
    /// pixel is in the upper bits of a byte. Most colour displays.
    MsbFirst,
    /// Least significant bit first (little endian): the lower byte of a pixel comes first, and the
    /// first pixel is in the lower bits of a byte.
    LsbFirst,
}

/// Packs pixels into bytes without gaps, and returns the number of pixels packed.
///
/// | pixel | most significant bit first | least significant bit first |
/// |---|---|---|
/// | [`Gray1`](super::Gray1), [`Gray2`](super::Gray2), [`Gray4`](super::Gray4) | first pixel in the upper bits | first pixel in the lower bits, as a column of the SSD1306 |
/// | [`Rgb332`](super::Rgb332), [`Gray8`](super::Gray8) | a byte | a byte |
/// | [`Rgb444`](super::Rgb444) | `RRRRGGGG BBBBRRRR GGGGBBBB`: ST7735, ST7789 | `GGGGBBBB BBBBRRRR RRRRGGGG` |
/// | [`Rgb555`](super::Rgb555), [`Rgb565`](super::Rgb565) | upper byte, lower byte | lower byte, upper byte |
/// | [`Rgb666`](super::Rgb666) | `RRRRRR00 GGGGGG00 BBBBBB00`: ILI9488, ST7789 | `BBBBBB00 GGGGGG00 RRRRRR00` |
/// | [`Rgb888`](super::Rgb888) | red, green, blue | blue, green, red |
///
/// Where the bytes are too few, the result is less than the number of pixels: pixels that do not fit
/// as a whole are not packed. The unused bits of the last byte are 0, and further bytes are unchanged.
/// A row of `n` pixels takes `(n * P::PACKED_BITS).div_ceil(8)` bytes.
///
/// ```
/// use luminaire::display::{Gray1, Layout, Rgb444, pack};
/// let mut bytes = [0; 3];
/// assert_eq!(pack(&[Rgb444(0x123), Rgb444(0x456), Rgb444(0x789)], Layout::MsbFirst, &mut bytes), 2);
/// assert_eq!(bytes, [0x12, 0x34, 0x56]);
/// pack(&[Gray1(1), Gray1(1), Gray1(0)], Layout::LsbFirst, &mut bytes);
/// assert_eq!(bytes, [0b011, 0x34, 0x56]);
/// ```
#[inline]
pub fn pack<P: Pixel>(pixels: &[P], layout: Layout, bytes: &mut [u8]) -> usize {
    let fitting = bytes.len().saturating_mul(8) / P::PACKED_BITS as usize;
    let count = pixels.len().min(fitting);
    let mut bytes = bytes.iter_mut();
    // Bits that no byte has yet: fewer than 8 before a pixel, which adds at most 24.
    let (mut held, mut width) = (0, 0);
    for pixel in pixels.iter().take(count) {
        let bits = match (P::BITS, pixel.to_bits()) {
            // The six bits of a channel are the upper ones of a byte.
            (18, bits) => (bits & 0x3_f000) << 6 | (bits & 0xfc0) << 4 | (bits & 0x3f) << 2,
            (_, bits) => bits,
        };
        match layout {
            Layout::MsbFirst => held = held << P::PACKED_BITS | bits,
            Layout::LsbFirst => held |= bits << width,
        }
        width += P::PACKED_BITS;
        while width >= 8 {
            width -= 8;
            let (byte, rest) = match layout {
                Layout::MsbFirst => (held >> width, held),
                Layout::LsbFirst => (held, held >> 8),
            };
            bytes.by_ref().take(1).for_each(|to| *to = byte as u8);
            held = rest;
        }
    }
    if width > 0 {
        let byte = if layout == Layout::MsbFirst { held << (8 - width) } else { held };
        bytes.take(1).for_each(|to| *to = byte as u8);
    }
    count
}
