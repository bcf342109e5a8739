//! Pixels of small displays: 5 bits of red, 6 of green, 5 of blue.

use super::srgb::nearest_code;
use crate::{color::Rgb, number::Scalar};

/// A pixel of 16 bits: five upper bits of red, six middle bits of green, five lower bits of blue.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
#[repr(transparent)]
pub struct Rgb565(pub u16);

/// Converts a code in `[0, 255]` to the nearest code in `[0, last]`.
const fn nearest(code: u8, last: u16) -> u16 {
    (code as u16 * last + 127) / 255
}

/// Converts a code in `[0, last]` to the nearest code in `[0, 255]`.
const fn widened(code: u16, last: u16) -> u8 {
    ((code * 255 + last / 2) / last) as u8
}

impl Rgb565 {
    pub(super) const fn pack(red: u16, green: u16, blue: u16) -> Self {
        Self(red << 11 | green << 5 | blue)
    }

    /// Returns the nearest pixel to codes of eight bits.
    ///
    /// ```
    /// use luminaire::{Rgb, display::Rgb565};
    /// assert_eq!(Rgb565::from_codes(Rgb::new(255, 128, 0)), Rgb565(0b11111_100000_00000));
    /// ```
    #[inline]
    pub const fn from_codes(codes: Rgb<u8>) -> Self {
        Self::pack(nearest(codes.red, 31), nearest(codes.green, 63), nearest(codes.blue, 31))
    }

    /// Returns the nearest sRGB pixel to a linear colour, clipped to `[0, 1]`.
    ///
    /// The colour is rounded once; a conversion through codes of eight bits would round some
    /// colours twice. In fixed point the result is exactly the nearest pixel, and the conversion
    /// uses no floats.
    #[inline]
    pub fn from_linear<S: Scalar>(color: Rgb<S>) -> Self {
        let red = nearest_code::<S, 31>(color.red);
        let green = nearest_code::<S, 63>(color.green);
        let blue = nearest_code::<S, 31>(color.blue);
        Self::pack(red.into(), green.into(), blue.into())
    }

    /// Returns the nearest codes of eight bits. [`from_codes`](Self::from_codes) restores the pixel
    /// from these codes.
    pub const fn to_codes(self) -> Rgb<u8> {
        Rgb::new(widened(self.0 >> 11, 31), widened(self.0 >> 5 & 63, 63), widened(self.0 & 31, 31))
    }

    /// Returns the two bytes, first the upper byte with red: the order that most SPI displays
    /// expect.
    ///
    /// ```
    /// use luminaire::display::Rgb565;
    /// assert_eq!(Rgb565(0b11111_100000_00000).to_be_bytes(), [0b11111_100, 0b000_00000]);
    /// ```
    #[inline]
    pub const fn to_be_bytes(self) -> [u8; 2] {
        self.0.to_be_bytes()
    }

    /// Returns the two bytes, first the lower byte with blue.
    #[inline]
    pub const fn to_le_bytes(self) -> [u8; 2] {
        self.0.to_le_bytes()
    }
}

impl From<u16> for Rgb565 {
    fn from(bits: u16) -> Self {
        Self(bits)
    }
}

impl From<Rgb565> for u16 {
    fn from(pixel: Rgb565) -> Self {
        pixel.0
    }
}
