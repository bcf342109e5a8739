//! Pixels of displays: colours of 8 to 24 bits, in the sRGB encoding.

use super::{
    curve::Srgb,
    dither::{self, dithered, steps},
    srgb::{first_step, nearest_code},
};
use crate::{
    color::Rgb,
    number::Scalar,
    source::{Named, named},
};

/// Seals [`Pixel`], and has the channels of a pixel for tables of [levels](super::levels).
pub trait Sealed: Copy + PartialEq + core::fmt::Debug + Named {
    /// The bits of each channel. A grey pixel has a green channel only.
    const WIDTHS: Rgb<u32>;
    /// The fraction bits of each channel in a level.
    const FRACTION: u32 = {
        let free = (32 - Self::WIDTHS.red - Self::WIDTHS.green - Self::WIDTHS.blue) / 3;
        if free < 5 { free } else { 5 }
    };

    /// Returns the channels of a linear colour clipped to `[0, 1]`, in steps with
    /// [`FRACTION`](Self::FRACTION) bits.
    fn steps(color: Rgb<f32>) -> Rgb<u32>;

    /// Returns the pixel of these bits; higher ones are cut off.
    fn of_bits(bits: u32) -> Self;
}

/// A pixel of a display: [`Gray1`](super::Gray1) to [`Gray8`](super::Gray8), [`Rgb332`] to
/// [`Rgb888`].
///
/// The trait is sealed. A table is only linked for a width of channels that is used.
///
/// ```
/// use luminaire::{Fx16, Rgb, display::{Gray4, Pixel, Rgb332, Rgb565}};
/// let amber = Rgb::new(1.0, 0.35, 0.01).map(Fx16::from_f32);
/// assert_eq!(Rgb332::nearest(amber), Rgb332(0b111_100_00));
/// assert_eq!(Gray4::dithered(amber, 3, 5), Gray4(11));
/// assert_eq!(Rgb565::from_codes(Rgb::new(255, 128, 0)), Rgb565(0b11111_100000_00000));
/// ```
pub trait Pixel: Sealed {
    /// The number of bits of a pixel.
    const BITS: u32;
    /// The number of bits that a pixel takes in [`pack`](super::pack), with its unused bits.
    const PACKED_BITS: u32 = match Self::BITS {
        15 => 16,
        18 => 24,
        bits => bits,
    };
    /// The light of the first step, rounded down: a pixel without dither whose channels are all below
    /// this is black.
    ///
    /// With it a program skips lights that are too far to be seen: see
    /// [`SpotLight::range_above`](crate::SpotLight::range_above).
    const FIRST_STEP: f32;

    /// Returns the nearest sRGB pixel to a linear colour, clipped to `[0, 1]`: each channel has
    /// exactly the nearest code.
    fn nearest<S: Scalar>(color: Rgb<S>) -> Self;

    /// Returns the pixel of a linear colour at `(x, y)`, with ordered dither.
    ///
    /// Each channel is dithered as by [`encode_srgb_dithered`](super::encode_srgb_dithered), with
    /// codes of the channel's width: the mean light of a cell of 8 x 8 pixels is within 0.0081 of a
    /// step.
    fn dithered<S: Scalar>(color: Rgb<S>, x: u32, y: u32) -> Self;

    /// Returns the lowest [`BITS`](Self::BITS) bits of the pixel: red above green above blue.
    fn to_bits(self) -> u32;

    /// Returns the nearest codes of eight bits, such as for a preview; grey has three equal codes.
    fn to_codes(self) -> Rgb<u8>;
}

/// Converts a code in `[0, 255]` to the nearest code in `[0, last]`.
const fn narrowed(code: u8, last: u16) -> u16 {
    (code as u16 * last + 127) / 255
}

/// Converts a code in `[0, last]` to the nearest code in `[0, 255]`.
pub(super) const fn widened(code: u16, last: u16) -> u8 {
    ((code * 255 + last / 2) / last) as u8
}

/// Declares pixels with the bits of red, green and blue.
macro_rules! pixels {
    ($($(#[$doc:meta])* $name:ident($store:ty): $red:literal $green:literal $blue:literal;)*) => {$(
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

        named!($name);

        impl Sealed for $name {
            const WIDTHS: Rgb<u32> = Rgb::new($red, $green, $blue);

            fn steps(color: Rgb<f32>) -> Rgb<u32> {
                let red = steps::<{ (1 << $red) - 1 }>(color.red, Self::FRACTION);
                let green = steps::<{ (1 << $green) - 1 }>(color.green, Self::FRACTION);
                let blue = steps::<{ (1 << $blue) - 1 }>(color.blue, Self::FRACTION);
                Rgb::new(red, green, blue)
            }

            #[inline(always)]
            fn of_bits(bits: u32) -> Self {
                Self(bits as _)
            }
        }

        impl Pixel for $name {
            const BITS: u32 = $red + $green + $blue;
            // No channel is wider than green.
            const FIRST_STEP: f32 = first_step((1 << $green) - 1);

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

            #[inline]
            fn to_codes(self) -> Rgb<u8> {
                self.to_codes()
            }
        }
    )*};
}

pixels! {
    /// A pixel of eight bits: three upper bits of red, three of green, two lower bits of blue.
    Rgb332(u8): 3 3 2;
    /// A pixel of twelve bits: four of red above four of green and four of blue.
    Rgb444(u16): 4 4 4;
    /// A pixel of 15 bits: five of red above five of green and five of blue.
    Rgb555(u16): 5 5 5;
    /// A pixel of 16 bits: five upper bits of red, six middle bits of green, five lower bits of blue.
    Rgb565(u16): 5 6 5;
    /// A pixel of 18 bits: six of red above six of green and six of blue.
    Rgb666(u32): 6 6 6;
    /// A pixel of 24 bits: eight of red above eight of green and eight of blue.
    Rgb888(u32): 8 8 8;
}
