//! Fixed-point number types, with the layouts of types of the crate `fixed`.

use core::fmt;

use crate::vec3::Vec3;
use fixed::types::{I2F14, I2F30, I16F16, I18F14, I34F30, U3F29, U18F14, U34F30};

/// Declares number types from types of `fixed`, with the integers that store them.
macro_rules! numbers {
    ($($(#[$doc:meta])* $name:ident($fixed:ident, $bits:ty);)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
        #[repr(transparent)]
        pub struct $name($bits);

        impl $name {
            /// Zero.
            pub const ZERO: Self = Self(0);
            /// One.
            pub const ONE: Self = Self(1 << Self::FRACTION_BITS);
            /// The smallest number.
            pub const MIN: Self = Self(<$bits>::MIN);
            /// The largest number.
            pub const MAX: Self = Self(<$bits>::MAX);
            /// The number of fraction bits.
            pub const FRACTION_BITS: u32 = $fixed::FRAC_NBITS;

            /// Returns the number stored as these bits: `bits / 2^FRACTION_BITS`.
            #[inline]
            pub const fn from_bits(bits: $bits) -> Self {
                Self(bits)
            }

            /// Returns the bits that store the number.
            #[inline]
            pub const fn to_bits(self) -> $bits {
                self.0
            }

            /// Returns the number as f64: exact up to 53 significant bits, else rounded.
            pub const fn to_f64(self) -> f64 {
                self.0 as f64 / (1_u64 << Self::FRACTION_BITS) as f64
            }

            /// Returns the number as f32, rounded to nearest.
            pub const fn to_f32(self) -> f32 {
                self.0 as f32 / (1_u64 << Self::FRACTION_BITS) as f32
            }

            /// Returns the difference; saturates.
            #[inline]
            pub const fn saturating_sub(self, other: Self) -> Self {
                Self(self.0.saturating_sub(other.0))
            }

            /// Returns the sum; saturates.
            #[inline]
            pub const fn saturating_add(self, other: Self) -> Self {
                Self(self.0.saturating_add(other.0))
            }
        }

        impl From<$fixed> for $name {
            fn from(number: $fixed) -> Self {
                Self(number.to_bits())
            }
        }

        impl From<$name> for $fixed {
            fn from(number: $name) -> Self {
                Self::from_bits(number.0)
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(&$fixed::from_bits(self.0), out)
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Debug::fmt(&$fixed::from_bits(self.0), out)
            }
        }
    )*};
}

numbers! {
    /// A number of the 16-bit format, from -2 to 2 in steps of 2^-14: intensities, normals and
    /// colours.
    ///
    /// No product of the format is wider than 32 bits.
    Fx16(I2F14, i16);
    /// A number of the 32-bit format, from -2 to 2 in steps of 2^-30.
    ///
    /// The format uses this type for intensities, normals and colours. Both fixed-point formats use it for
    /// the components of directions. No product of the format is wider than 64 bits.
    Fx32(I2F30, i32);
    /// A component of a position in both fixed-point formats, from -32,768 to 32,768 units in steps
    /// of 2^-16.
    Length(I16F16, i32);
    /// Irradiance in the format [`Fx16`], from 0 to 2^18 in steps of 2^-14; 1 is full scale.
    Light16(U18F14, u32);
    /// Irradiance in the format [`Fx32`], from 0 to 2^34 in steps of 2^-30; 1 is full scale.
    Light32(U34F30, u64);
    /// A versine in both fixed-point formats, scaled to a cone, in steps of 2^-29.
    Versine(U3F29, u32);
    /// A coefficient of a falloff in the format [`Fx16`], in steps of 2^-14.
    Weight16(I18F14, i32);
    /// A coefficient of a falloff in the format [`Fx32`], in steps of 2^-30.
    Weight32(I34F30, i64);
}

/// Implements the sum of light, which saturates.
macro_rules! summed {
    ($($name:ident)*) => {$(
        impl core::ops::Add for $name {
            type Output = Self;

            #[inline]
            fn add(self, other: Self) -> Self {
                self.saturating_add(other)
            }
        }

        impl core::ops::AddAssign for $name {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }
    )*};
}

summed!(Light16 Light32);

impl Fx16 {
    /// Returns the point with these coordinates, each rounded to the nearest length.
    pub const fn point([x, y, z]: [f32; 3]) -> Vec3<Length> {
        Vec3::new(Length::from_f32(x), Length::from_f32(y), Length::from_f32(z))
    }

    /// Returns the normal with these components, each rounded to the nearest number.
    pub const fn normal([x, y, z]: [f32; 3]) -> Vec3<Self> {
        Vec3::new(Self::from_f32(x), Self::from_f32(y), Self::from_f32(z))
    }

    /// Returns the nearest number, ties to even; saturates, and NaN becomes zero.
    #[inline]
    pub const fn from_f32(value: f32) -> Self {
        let steps = nearest(value * 16_384.0);
        let (least, most) = (i16::MIN as i32, i16::MAX as i32);
        Self(if steps < least {
            i16::MIN
        } else if steps > most {
            i16::MAX
        } else {
            steps as i16
        })
    }
}

impl Fx32 {
    /// Returns the point with these coordinates, each rounded to the nearest length.
    pub const fn point([x, y, z]: [f32; 3]) -> Vec3<Length> {
        Vec3::new(Length::from_f32(x), Length::from_f32(y), Length::from_f32(z))
    }

    /// Returns the normal with these components, each rounded to the nearest number.
    pub const fn normal([x, y, z]: [f32; 3]) -> Vec3<Self> {
        Vec3::new(Self::from_f32(x), Self::from_f32(y), Self::from_f32(z))
    }

    /// Returns the nearest number, ties to even; saturates, and NaN becomes zero.
    #[inline]
    pub const fn from_f32(value: f32) -> Self {
        Self(nearest(value * 1_073_741_824.0))
    }
}

impl Length {
    /// Returns the length of a whole number of units.
    #[inline]
    pub const fn from_int(units: i16) -> Self {
        Self((units as i32) << 16)
    }

    /// Returns the nearest length, ties to even; saturates, and NaN becomes zero.
    #[inline]
    pub const fn from_f32(value: f32) -> Self {
        Self(nearest(value * 65_536.0))
    }
}

impl Light16 {
    /// Returns the nearest irradiance, ties to even; saturates, and a negative value or NaN becomes zero.
    #[inline]
    pub const fn from_f32(value: f32) -> Self {
        Self(rounded(value * 16_384.0) as u32)
    }
}

impl Light32 {
    /// Returns the nearest irradiance, ties to even; saturates, and a negative value or NaN becomes zero.
    #[inline]
    pub const fn from_f32(value: f32) -> Self {
        Self(rounded(value * 1_073_741_824.0) as u64)
    }
}

/// Returns the integer nearest to a value, ties to even; saturates, and NaN becomes zero.
///
/// The function has no branch, because renderers convert whole pictures with it. An f32 with a
/// magnitude of at least 2^23 is an integer. To a smaller value the function adds 2^23 with the
/// value's sign. This sum has no fraction bits, so the addition rounds.
#[inline]
pub(super) const fn nearest(value: f32) -> i32 {
    rounded(value) as i32
}

/// Returns the nearest integer as an f32, ties to even, for conversions to any integer type.
#[inline]
pub(super) const fn rounded(value: f32) -> f32 {
    const FIRST_INTEGER: f32 = 8_388_608.0;
    let units = FIRST_INTEGER.copysign(value);
    if value.abs() < FIRST_INTEGER { value + units - units } else { value }
}
