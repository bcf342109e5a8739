//! Grey pixels: the luminance of a colour, in the sRGB encoding.

use super::{
    curve::Srgb,
    dither::{dithered, dithered_word, steps, threshold},
    pixel::{Pixel, Sealed, widened},
    srgb::{first_step, nearest_code, nearest_of_word},
};
use crate::{
    color::Rgb,
    number::{Scalar, Word, float::clamp},
    source::named,
};

/// The weights of red and blue in the luminance (ITU-R BT.709: 0.2126 and 0.0722), in units of 2^-16.
/// Green has the rest, 0.7152, so that white stays white.
const RED: u16 = 13_933;
const BLUE: u16 = 4_732;

/// Returns the luminance of a linear colour clipped to `[0, 1]`.
///
/// In `Fx16` it is exact, in units of 2^-30; in `Fx32` it is rounded down to that unit.
#[inline]
fn luminance<S: Scalar>(color: Rgb<S>) -> Word {
    let Rgb { red, green, blue } = color.map(S::word);
    match (red, green, blue) {
        (Word::Single(red), Word::Single(green), Word::Single(blue)) => {
            let (red, green, blue) = (clamp(red), clamp(green), clamp(blue));
            let part = |weight| f32::from(weight) / 65_536.0;
            // As differences, so that equal channels have exactly their own luminance.
            Word::Single(green + part(RED) * (red - green) + part(BLUE) * (blue - green))
        }
        #[cfg(feature = "fixed")]
        (Word::Steps14(red), Word::Steps14(green), Word::Steps14(blue)) => {
            let [red, green, blue] = [red, green, blue].map(|channel| i32::from(channel.clamp(0, 1 << 14)));
            let sum = (green << 16) + i32::from(RED) * (red - green) + i32::from(BLUE) * (blue - green);
            Word::Steps30(sum)
        }
        #[cfg(feature = "fixed")]
        (Word::Steps30(red), Word::Steps30(green), Word::Steps30(blue)) => {
            let [red, green, blue] = [red, green, blue].map(|channel| i64::from(channel.clamp(0, 1 << 30)));
            let sum = (green << 16) + i64::from(RED) * (red - green) + i64::from(BLUE) * (blue - green);
            Word::Steps30((sum >> 16) as i32)
        }
        // The words of one format are of one kind.
        #[cfg(feature = "fixed")]
        _ => Word::Single(0.0),
    }
}

/// Declares grey pixels with their bits.
macro_rules! grays {
    ($($(#[$doc:meta])* $name:ident: $bits:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Debug)]
        #[repr(transparent)]
        pub struct $name(pub u8);

        impl $name {
            /// The last code: white.
            pub const LAST: u8 = u8::MAX >> (8 - $bits);

            /// Returns the nearest grey of light without a colour, such as one channel.
            #[inline]
            pub fn from_luminance<S: Scalar>(light: S) -> Self {
                Self(nearest_code::<S, Srgb, { (1 << $bits) - 1 }>(light))
            }

            /// Returns the grey of light without a colour at `(x, y)`, with ordered dither.
            #[inline]
            pub fn from_luminance_dithered<S: Scalar>(light: S, x: u32, y: u32) -> Self {
                Self(dithered::<S, Srgb, { (1 << $bits) - 1 }>(light, threshold(x, y)))
            }
        }

        named!($name);

        impl Sealed for $name {
            const WIDTHS: Rgb<u32> = Rgb::new(0, $bits, 0);

            fn steps(color: Rgb<f32>) -> Rgb<u32> {
                let gray = match luminance(color) {
                    Word::Single(gray) => gray,
                    #[cfg(feature = "fixed")]
                    _ => 0.0,
                };
                Rgb::new(0, steps::<{ (1 << $bits) - 1 }>(gray, Self::FRACTION), 0)
            }

            #[inline(always)]
            fn of_bits(bits: u32) -> Self {
                Self(bits as u8)
            }
        }

        /// The grey of a colour is that of its luminance in linear light, 0.2126 red + 0.7152 green +
        /// 0.0722 blue (ITU-R BT.709), within 5.4e-6 of full scale: the weights are multiples of 2^-16
        /// that sum to exactly 1, and are off by 5.3e-6 in all. In `Fx16` nothing else is rounded.
        impl Pixel for $name {
            const BITS: u32 = $bits;
            const FIRST_STEP: f32 = first_step((1 << $bits) - 1);

            #[inline]
            fn nearest<S: Scalar>(color: Rgb<S>) -> Self {
                Self(nearest_of_word::<Srgb, { (1 << $bits) - 1 }>(luminance(color)))
            }

            #[inline]
            fn dithered<S: Scalar>(color: Rgb<S>, x: u32, y: u32) -> Self {
                Self(dithered_word::<Srgb, { (1 << $bits) - 1 }>(luminance(color), threshold(x, y)))
            }

            #[inline]
            fn to_bits(self) -> u32 {
                u32::from(self.0 & Self::LAST)
            }

            #[inline]
            fn to_codes(self) -> Rgb<u8> {
                let code = widened((self.0 & Self::LAST).into(), Self::LAST.into());
                Rgb::new(code, code, code)
            }
        }
    )*};
}

grays! {
    /// A pixel that is black (0) or white (1).
    Gray1: 1;
    /// A pixel of four greys, in the two lower bits.
    Gray2: 2;
    /// A pixel of 16 greys, in the four lower bits.
    Gray4: 4;
    /// A pixel of 256 greys.
    Gray8: 8;
}
