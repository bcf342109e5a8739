//! What pixels of 5 bits of red, 6 of green and 5 of blue have besides those of other widths.

use super::pixel::{Pixel as _, Rgb565};
#[cfg(feature = "fixed")]
use super::{dither::threshold, fast};
use crate::{color::Rgb, number::Scalar};

impl Rgb565 {
    /// Returns the nearest sRGB pixel to a linear colour, clipped to `[0, 1]`.
    ///
    /// The colour is rounded once; a conversion through codes of eight bits would round some
    /// colours twice. In fixed point the result is exactly the nearest pixel, and the conversion
    /// uses no floats.
    #[inline]
    pub fn from_linear<S: Scalar>(color: Rgb<S>) -> Self {
        Self::nearest(color)
    }

    /// Returns the RGB565 pixel of a linear colour at `(x, y)`, with ordered dither.
    ///
    /// Each channel is dithered as by [`encode_srgb_dithered`](super::encode_srgb_dithered), with
    /// codes of five and six bits.
    #[inline(always)] // `rgb565-dithered` on Cortex-M0: +5 instructions without.
    pub fn from_linear_dithered<S: Scalar>(color: Rgb<S>, x: u32, y: u32) -> Self {
        Self::dithered(color, x, y)
    }

    /// Returns the pixel of [`from_linear_dithered`](Self::from_linear_dithered), bit for bit, with
    /// fewer instructions in fixed point.
    ///
    /// Tables of 1,552 bytes replace most of the search for the codes. The instructions and bytes
    /// of both are on the page of effects (`docs/EFFECTS.md`). In `f32` the two functions are the
    /// same.
    #[inline(always)] // As above.
    pub fn from_linear_dithered_fast<S: Scalar>(color: Rgb<S>, x: u32, y: u32) -> Self {
        #[cfg(feature = "fixed")]
        if let Some(codes) = fast::dithered(color, threshold(x, y)) {
            return Self((codes.red << 11 | codes.green << 5 | codes.blue) as u16);
        }
        Self::dithered(color, x, y)
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
}
