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
    self, Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, RgbColor,
    raw::{RawData as _, RawU1, RawU2, RawU4, RawU8, RawU16, RawU24},
};

/// Implements conversions between pixels and types with the same bits, and from these to types with
/// blue in the upper bits.
macro_rules! pixels {
    ($($name:ident: $same:ty, $raw:ident $(, $swapped:ident)?;)*) => {$(
        impl From<$name> for $same {
            fn from(pixel: $name) -> Self {
                $raw::new(pixel.0).into()
            }
        }

        impl From<$same> for $name {
            fn from(pixel: $same) -> Self {
                Self($raw::from(pixel).into_inner())
            }
        }

        $(
            impl From<$name> for $swapped {
                fn from(pixel: $name) -> Self {
                    <$same>::from(pixel).into()
                }
            }

            impl From<$swapped> for $name {
                fn from(pixel: $swapped) -> Self {
                    <$same>::from(pixel).into()
                }
            }
        )?
    )*};
}

pixels! {
    Gray1: BinaryColor, RawU1;
    Gray2: pixelcolor::Gray2, RawU2;
    Gray4: pixelcolor::Gray4, RawU4;
    Gray8: pixelcolor::Gray8, RawU8;
    Rgb555: pixelcolor::Rgb555, RawU16, Bgr555;
    Rgb565: pixelcolor::Rgb565, RawU16, Bgr565;
    Rgb666: pixelcolor::Rgb666, RawU24, Bgr666;
    Rgb888: pixelcolor::Rgb888, RawU24, Bgr888;
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
    use embedded_graphics_core::pixelcolor::{IntoStorage as _, raw::ToBytes as _};

    #[test]
    fn every_pixel_keeps_its_bits_and_comes_back() {
        macro_rules! assert_kept {
            ($($name:ident: $same:ty, $bits:literal $(, $swapped:ident)?;)*) => {$(
                // Of 2^24 pixels every 251st.
                for bits in (0..1_u32 << $bits).step_by(if $bits > 18 { 251 } else { 1 }) {
                    let pixel = $name(bits.try_into().expect("the bits of the pixel"));
                    let same = <$same>::from(pixel);
                    assert_eq!((u32::from(same.into_storage()), $name::from(same)), (bits, pixel));
                    $(
                        let swapped = $swapped::from(pixel);
                        assert_eq!((swapped.r(), swapped.g(), swapped.b()), (same.r(), same.g(), same.b()));
                        assert_eq!($name::from(swapped), pixel);
                    )?
                }
            )*};
        }
        assert_kept! {
            Gray2: pixelcolor::Gray2, 2;
            Gray4: pixelcolor::Gray4, 4;
            Gray8: pixelcolor::Gray8, 8;
            Rgb555: pixelcolor::Rgb555, 15, Bgr555;
            Rgb565: pixelcolor::Rgb565, 16, Bgr565;
            Rgb666: pixelcolor::Rgb666, 18, Bgr666;
            Rgb888: pixelcolor::Rgb888, 24, Bgr888;
        }
        assert_eq!([0, 1].map(|bit| BinaryColor::from(Gray1(bit))), [BinaryColor::Off, BinaryColor::On]);
        assert_eq!([BinaryColor::Off, BinaryColor::On].map(Gray1::from), [Gray1(0), Gray1(1)]);
        let color = Rgb::new(0xff, 0x9e, 0x1a);
        assert_eq!(Rgb565::from_codes(color).to_be_bytes(), pixelcolor::Rgb565::new(31, 39, 3).to_be_bytes());
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
}
