//! Pixels of displays: colours of 8 to 24 bits, in the sRGB encoding.

use super::{
    curve::Srgb,
    dither::{self, dithered},
    srgb::nearest_code,
};
use crate::{color::Rgb, number::Scalar};

/// How a pixel is packed. The trait is private, which seals [`Pixel`].
pub trait Packed: Copy {
    /// Returns the lowest [`Pixel::PACKED_BITS`] bits as a display expects them.
    fn packed(self) -> u32;
}

/// A pixel of a display: [`Gray1`](super::Gray1) to [`Gray8`](super::Gray8), [`Rgb332`] to
/// [`Rgb888`].
///
/// The trait is sealed. A table is only linked for a width of channels that is used.
///
/// ```
/// use luminaire::{Fx16, Rgb, display::{Gray4, Pixel, Rgb332}};
/// let amber = Rgb::new(1.0, 0.35, 0.01).map(Fx16::from_f32);
/// assert_eq!(Rgb332::nearest(amber), Rgb332(0b111_100_00));
/// assert_eq!(Gray4::dithered(amber, 3, 5), Gray4(11));
/// ```
pub trait Pixel: Packed {
    /// The number of bits of a pixel.
    const BITS: u32;
    /// The number of bits that a pixel takes in [`pack`](super::pack): unused bits count.
    const PACKED_BITS: u32;

    /// Returns the pixel nearest to a linear colour clipped to `[0, 1]`, channel by channel, in the
    /// sRGB encoding.
    ///
    /// The colour is rounded once, to exactly the nearest code of each channel.
    fn nearest<S: Scalar>(color: Rgb<S>) -> Self;

    /// Returns the pixel of a linear colour at `(x, y)`, with ordered dither in linear light.
    ///
    /// Each channel is dithered as by [`encode_srgb_dithered`](super::encode_srgb_dithered), with
    /// codes of the channel's width: over a cell of 8 x 8 pixels the mean light is correct, within
    /// 0.0081 of a step.
    fn dithered<S: Scalar>(color: Rgb<S>, x: u32, y: u32) -> Self;

    /// Returns the bits of the pixel in the lowest [`BITS`](Self::BITS) bits: red above green above
    /// blue.
    fn to_bits(self) -> u32;
}

/// Converts a code in `[0, 255]` to the nearest code in `[0, last]`.
const fn narrowed(code: u8, last: u16) -> u16 {
    (code as u16 * last + 127) / 255
}

/// Converts a code in `[0, last]` to the nearest code in `[0, 255]`.
const fn widened(code: u16, last: u16) -> u8 {
    ((code * 255 + last / 2) / last) as u8
}

/// Declares pixels with the bits of red, green and blue, and how they are packed.
macro_rules! pixels {
    ($($(#[$doc:meta])* $name:ident($store:ty): $red:literal $green:literal $blue:literal,
       packed in $packed:literal by $pack:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
        #[repr(transparent)]
        pub struct $name(pub $store);

        impl $name {
            const LAST: Rgb<u16> = Rgb::new((1 << $red) - 1, (1 << $green) - 1, (1 << $blue) - 1);

            #[inline(always)]
            pub(super) const fn of_channels(red: u16, green: u16, blue: u16) -> Self {
                let (red, green, blue) = (red as u32, green as u32, blue as u32);
                Self((red << ($green + $blue) | green << $blue | blue) as _)
            }

            /// Returns the nearest pixel to codes of eight bits.
            #[inline]
            pub const fn from_codes(codes: Rgb<u8>) -> Self {
                let last = Self::LAST;
                Self::of_channels(
                    narrowed(codes.red, last.red),
                    narrowed(codes.green, last.green),
                    narrowed(codes.blue, last.blue),
                )
            }

            /// Returns the nearest codes of eight bits. [`from_codes`](Self::from_codes) restores the
            /// pixel from these codes.
            pub const fn to_codes(self) -> Rgb<u8> {
                let last = Self::LAST;
                Rgb::new(
                    widened((self.0 >> ($green + $blue)) as u16 & last.red, last.red),
                    widened((self.0 >> $blue) as u16 & last.green, last.green),
                    widened(self.0 as u16 & last.blue, last.blue),
                )
            }
        }

        impl From<$store> for $name {
            fn from(bits: $store) -> Self {
                Self(bits)
            }
        }

        impl From<$name> for $store {
            fn from(pixel: $name) -> Self {
                pixel.0
            }
        }

        impl Packed for $name {
            #[inline]
            fn packed(self) -> u32 {
                ($pack)(self.to_bits())
            }
        }

        impl Pixel for $name {
            const BITS: u32 = $red + $green + $blue;
            const PACKED_BITS: u32 = $packed;

            #[inline]
            fn nearest<S: Scalar>(color: Rgb<S>) -> Self {
                let red = nearest_code::<S, Srgb, { (1 << $red) - 1 }>(color.red);
                let green = nearest_code::<S, Srgb, { (1 << $green) - 1 }>(color.green);
                let blue = nearest_code::<S, Srgb, { (1 << $blue) - 1 }>(color.blue);
                Self::of_channels(red.into(), green.into(), blue.into())
            }

            #[inline(always)] // `rgb565-dithered` on Cortex-M0: +5 instructions without.
            fn dithered<S: Scalar>(color: Rgb<S>, x: u32, y: u32) -> Self {
                let threshold = dither::threshold(x, y);
                let red = dithered::<S, Srgb, { (1 << $red) - 1 }>(color.red, threshold);
                let green = dithered::<S, Srgb, { (1 << $green) - 1 }>(color.green, threshold);
                let blue = dithered::<S, Srgb, { (1 << $blue) - 1 }>(color.blue, threshold);
                Self::of_channels(red.into(), green.into(), blue.into())
            }

            #[inline]
            fn to_bits(self) -> u32 {
                self.0 as u32 & u32::MAX >> (32 - Self::BITS)
            }
        }
    )*};
}

pixels! {
    /// A pixel of a byte: three upper bits of red, three of green, two lower bits of blue.
    Rgb332(u8): 3 3 2, packed in 8 by |bits| bits;
    /// A pixel of twelve bits, four for each channel: red in the upper bits. The upper four bits of the
    /// integer are unused.
    ///
    /// Packed, two pixels take three bytes.
    Rgb444(u16): 4 4 4, packed in 12 by |bits| bits;
    /// A pixel of 15 bits, five for each channel: red in the upper bits. The upper bit of the integer
    /// is unused.
    ///
    /// Packed, a pixel takes two bytes.
    Rgb555(u16): 5 5 5, packed in 16 by |bits| bits;
    /// A pixel of 16 bits: five upper bits of red, six middle bits of green, five lower bits of blue.
    Rgb565(u16): 5 6 5, packed in 16 by |bits| bits;
    /// A pixel of 18 bits, six for each channel: red in the upper bits. The upper 14 bits of the integer
    /// are unused.
    ///
    /// Packed, each channel is in the upper six bits of a byte, as controllers such as the ILI9488 and
    /// the ST7789 expect it by SPI.
    Rgb666(u32): 6 6 6, packed in 24 by |bits| (bits & 0x3f000) << 6 | (bits & 0xfc0) << 4 | (bits & 0x3f) << 2;
    /// A pixel of 24 bits, eight for each channel: red in the upper bits. The upper byte of the integer
    /// is unused.
    Rgb888(u32): 8 8 8, packed in 24 by |bits| bits;
}
