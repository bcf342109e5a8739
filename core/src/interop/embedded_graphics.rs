//! Lossless conversions of colours from and to the colours of `embedded-graphics-core`.
//!
//! | here | there |
//! |---|---|
//! | [`Gray1`] | `BinaryColor`: white is on |
//! | [`Gray2`], [`Gray4`], [`Gray8`] | the type of the same name |
//! | [`Rgb555`], [`Rgb565`], [`Rgb666`], [`Rgb888`] | the type of the same name, and with `Bgr` |
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

use crate::{
    color::Rgb,
    display::{Gray1, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888},
};
use embedded_graphics_core::pixelcolor::{
    self, Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, GrayColor, IntoStorage, RgbColor,
    raw::{RawU16, RawU24},
};

impl From<Gray1> for BinaryColor {
    fn from(pixel: Gray1) -> Self {
        (pixel.0 & Gray1::LAST == 1).into()
    }
}

impl From<BinaryColor> for Gray1 {
    fn from(color: BinaryColor) -> Self {
        Self(color.is_on().into())
    }
}

/// Implements conversions between greys and types of the same names.
macro_rules! grays {
    ($($name:ident)*) => {$(
        impl From<$name> for pixelcolor::$name {
            fn from(pixel: $name) -> Self {
                Self::new(pixel.0)
            }
        }

        impl From<pixelcolor::$name> for $name {
            fn from(color: pixelcolor::$name) -> Self {
                Self(color.luma())
            }
        }
    )*};
}

grays!(Gray2 Gray4 Gray8);

/// Implements conversions between pixels and types of the same names, and those with blue in the
/// upper bits.
macro_rules! pixels {
    ($($name:ident($raw:ident) $swapped:ident;)*) => {$(
        impl From<$name> for pixelcolor::$name {
            fn from(pixel: $name) -> Self {
                $raw::new(pixel.0).into()
            }
        }

        impl From<pixelcolor::$name> for $name {
            fn from(pixel: pixelcolor::$name) -> Self {
                Self(pixel.into_storage())
            }
        }

        impl From<$name> for $swapped {
            fn from(pixel: $name) -> Self {
                pixelcolor::$name::from(pixel).into()
            }
        }

        impl From<$swapped> for $name {
            fn from(pixel: $swapped) -> Self {
                pixelcolor::$name::from(pixel).into()
            }
        }
    )*};
}

pixels! {
    Rgb555(RawU16) Bgr555;
    Rgb565(RawU16) Bgr565;
    Rgb666(RawU24) Bgr666;
    Rgb888(RawU24) Bgr888;
}

/// Implements conversions between codes of eight bits and types with their own channel order.
macro_rules! both_ways {
    ($($other:ty),*) => {$(
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

both_ways!(pixelcolor::Rgb888, Bgr888);

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
            let (rgb, bgr) = (pixelcolor::Rgb888::from(color), Bgr888::from(color));
            assert_eq!(rgb.to_be_bytes(), [code, 1, 255 - code]);
            assert_eq!(bgr.to_be_bytes(), [255 - code, 1, code]);
            assert_eq!((Rgb::from(rgb), Rgb::from(bgr)), (color, color));
        }
    }
    /// Each pixel of a grid over all codes has the channels of the type of the same name, red and blue
    /// swapped in the other, and comes back.
    #[test]
    fn pixels_keep_their_channels_and_come_back() {
        macro_rules! assert_kept {
            ($($name:ident $swapped:ident)*) => {$(
                for codes in (0..4_096_u16).map(|i| crate::display::Rgb444(i).to_codes()) {
                    let pixel = $name::from_codes(codes);
                    let (rgb, bgr) = (pixelcolor::$name::from(pixel), $swapped::from(pixel));
                    assert_eq!([rgb.r(), rgb.g(), rgb.b()], [bgr.r(), bgr.g(), bgr.b()]);
                    let Rgb { red, green, blue } = codes;
                    let near = |code: u8, last: u8| (u32::from(code) * u32::from(last) + 127) / 255;
                    let last = [pixelcolor::$name::MAX_R, pixelcolor::$name::MAX_G, pixelcolor::$name::MAX_B];
                    let expected = [near(red, last[0]), near(green, last[1]), near(blue, last[2])];
                    assert_eq!([rgb.r(), rgb.g(), rgb.b()].map(u32::from), expected);
                    assert_eq!(($name::from(rgb), $name::from(bgr)), (pixel, pixel));
                }
            )*};
        }
        assert_kept!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888);
        for code in 0..=u8::MAX {
            let gray = (Gray2(code & 3), Gray4(code & 15), Gray8(code));
            let there: (pixelcolor::Gray2, pixelcolor::Gray4, pixelcolor::Gray8) =
                (gray.0.into(), gray.1.into(), gray.2.into());
            assert_eq!((there.0.luma(), there.1.luma(), there.2.luma()), (code & 3, code & 15, code));
            assert_eq!((there.0.into(), there.1.into(), there.2.into()), gray);
        }
        assert_eq!([0, 1].map(|code| BinaryColor::from(Gray1(code))), [BinaryColor::Off, BinaryColor::On]);
        assert_eq!([BinaryColor::Off, BinaryColor::On].map(Gray1::from), [Gray1(0), Gray1(1)]);
    }
}
