//! Values as words: the bits that the file stores.

use luminaire::Scalar;
use luminaire::number::{Fx16, Fx32, Length, Light16, Light32, Versine};

/// A value that is stored in a word.
pub trait Word: Copy {
    /// The name of the format, with its integer and fraction bits.
    const NAME: &'static str;
    /// The number of hexadecimal digits of a word.
    const DIGITS: usize;

    /// The value with these bits.
    fn from_word(word: u64) -> Self;
    /// The bits of the value.
    fn word(self) -> u64;
}

macro_rules! fixed_word {
    ($($name:literal: $fixed:ty, $signed:ty, $unsigned:ty;)*) => {
        $(impl Word for $fixed {
            const NAME: &'static str = $name;
            const DIGITS: usize = size_of::<$unsigned>() * 2;

            fn from_word(word: u64) -> Self {
                Self::from_bits(word as $unsigned as $signed)
            }

            fn word(self) -> u64 {
                self.to_bits() as $unsigned as u64
            }
        })*
    };
}

fixed_word! {
    "i2f14": Fx16, i16, u16;
    "i2f30": Fx32, i32, u32;
    "i16f16": Length, i32, u32;
    "u3f29": Versine, u32, u32;
    "u18f14": Light16, u32, u32;
    "u34f30": Light32, u64, u64;
}

macro_rules! whole_word {
    ($($name:literal: $whole:ty;)*) => {
        $(impl Word for $whole {
            const NAME: &'static str = $name;
            const DIGITS: usize = size_of::<$whole>() * 2;

            fn from_word(word: u64) -> Self {
                word as $whole
            }

            fn word(self) -> u64 {
                self as u64
            }
        })*
    };
}

whole_word! {
    "u8": u8;
    "u16": u16;
    "u32": u32;
}

impl Word for f32 {
    const NAME: &'static str = "f32";
    const DIGITS: usize = 8;

    fn from_word(word: u64) -> Self {
        Self::from_bits(word as u32)
    }

    /// Returns the same word for every NaN, whatever its payload.
    fn word(self) -> u64 {
        u64::from(if self.is_nan() { 0x7fc0_0000 } else { self.to_bits() })
    }
}

/// A number format whose values are words.
pub trait Format: Scalar<Length: Word, Unit: Word, Versine: Word, Irradiance: Word> + Word {}

impl<S: Scalar<Length: Word, Unit: Word, Versine: Word, Irradiance: Word> + Word> Format for S {}
