//! Lossless conversions of colours from and to the colours of `embedded-graphics-core`.
//!
//! | here | there |
//! |---|---|
//! | [`Rgb565`] | `Rgb565`, `Bgr565` |
//! | [`Rgb<u8>`](Rgb) | `Rgb888`, `Bgr888` |
//!
//! The trait `ToBytes` of `embedded-graphics-core` chooses the byte order. `Rgb` types have red in
//! the upper bits, and `Bgr` types have blue in the upper bits. Most SPI displays expect big
//! endian: the upper byte first.
//!
//! ```
//! use embedded_graphics_core::pixelcolor::{Bgr565, Bgr888, Rgb565, Rgb888, raw::ToBytes};
//! use luminaire::{Rgb, display};
//!
//! let amber = Rgb::new(0xff_u8, 0x9e, 0x1a);
//! assert_eq!(Rgb888::from(amber).to_be_bytes(), [0xff, 0x9e, 0x1a]);
//! assert_eq!(Rgb888::from(amber).to_le_bytes(), [0x1a, 0x9e, 0xff]);
//! assert_eq!(Bgr888::from(amber).to_be_bytes(), [0x1a, 0x9e, 0xff]);
//!
//! let pixel = display::Rgb565::from_codes(amber);
//! assert_eq!(Rgb565::from(pixel).to_be_bytes(), [0b11111_100, 0b111_00011]);
//! assert_eq!(Rgb565::from(pixel).to_be_bytes(), pixel.to_be_bytes());
//! assert_eq!(Rgb565::from(pixel).to_le_bytes(), pixel.to_le_bytes());
//! assert_eq!(Bgr565::from(pixel).to_be_bytes(), [0b00011_100, 0b111_11111]);
//! ```

use crate::{color::Rgb, display::Rgb565};
use embedded_graphics_core::pixelcolor::{self, Bgr565, Bgr888, IntoStorage, Rgb888, RgbColor, raw::RawU16};

impl From<Rgb565> for pixelcolor::Rgb565 {
    fn from(pixel: Rgb565) -> Self {
        RawU16::new(pixel.0).into()
    }
}

impl From<pixelcolor::Rgb565> for Rgb565 {
    fn from(pixel: pixelcolor::Rgb565) -> Self {
        Self(pixel.into_storage())
    }
}

impl From<Rgb565> for Bgr565 {
    fn from(pixel: Rgb565) -> Self {
        pixelcolor::Rgb565::from(pixel).into()
    }
}

impl From<Bgr565> for Rgb565 {
    fn from(pixel: Bgr565) -> Self {
        pixelcolor::Rgb565::from(pixel).into()
    }
}

/// Implements conversions between codes of eight bits and types with their own channel order.
macro_rules! both_ways {
    ($($other:ident)*) => {$(
        impl From<Rgb<u8>> for $other {
            fn from(Rgb { red, green, blue }: Rgb<u8>) -> Self {
                Self::new(red, green, blue)
            }
        }

        impl From<$other> for Rgb<u8> {
            fn from(codes: $other) -> Self {
                Self::new(codes.r(), codes.g(), codes.b())
            }
        }
    )*};
}

both_ways!(Rgb888 Bgr888);

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics_core::pixelcolor::raw::ToBytes as _;

    #[test]
    fn every_pixel_keeps_its_bits_and_comes_back() {
        for pixel in (0..=u16::MAX).map(Rgb565) {
            let (rgb, bgr) = (pixelcolor::Rgb565::from(pixel), Bgr565::from(pixel));
            assert_eq!(rgb.into_storage(), pixel.0);
            assert_eq!((rgb.to_be_bytes(), rgb.to_le_bytes()), (pixel.to_be_bytes(), pixel.to_le_bytes()));
            let swapped = pixel.0 >> 11 | pixel.0 & 0x07e0 | pixel.0 << 11;
            assert_eq!(bgr.into_storage(), swapped);
            assert_eq!((Rgb565::from(rgb), Rgb565::from(bgr)), (pixel, pixel));
        }
    }

    #[test]
    fn codes_of_eight_bits_keep_their_channels_and_come_back() {
        for code in 0..=u8::MAX {
            let color = Rgb::new(code, 1, 255 - code);
            let (rgb, bgr) = (Rgb888::from(color), Bgr888::from(color));
            assert_eq!(rgb.to_be_bytes(), [code, 1, 255 - code]);
            assert_eq!(bgr.to_be_bytes(), [255 - code, 1, code]);
            assert_eq!((Rgb::from(rgb), Rgb::from(bgr)), (color, color));
        }
    }
}
