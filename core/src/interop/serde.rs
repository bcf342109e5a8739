//! `serde` serialisation of vectors, colours, angles and numbers.
//!
//! | type | serialised as |
//! |---|---|
//! | [`Vec3`] | an array of three: x, y, z |
//! | [`Rgb`] | an array of three: red, green, blue |
//! | [`Rgb565`] | its 16 bits, as one integer |
//! | [`Angle`], [`HalfAngle`] | degrees: the full angle, the half angle |
//! | fixed-point numbers | their bits, as one integer: exact |
//!
//! Each type accepts every value of its serialised form; for any other value the data format
//! returns an error. Descriptions such as a cone or a light are not serialisable, because their
//! constructors validate: store the constructor's arguments, and construct again.
//!
//! ```
//! use luminaire::{Angle, Vec3};
//! assert_eq!(serde_json::to_string(&Vec3::new(0.5, 4.0, -1.0))?, "[0.5,4.0,-1.0]");
//! assert_eq!(serde_json::from_str::<Angle>("36.0")?, Angle::degrees(36.0));
//! # Ok::<(), serde_json::Error>(())
//! ```

#[cfg(feature = "fixed")]
use crate::number::{Fx16, Fx32, Length, Light16, Light32, Versine, Weight16, Weight32};
use crate::{
    angle::{Angle, HalfAngle},
    color::Rgb,
    display::Rgb565,
    vec3::Vec3,
};
use serde_core::{Deserialize, Deserializer, Serialize, Serializer};

/// Implements serialisation of three components as an array.
macro_rules! array {
    ($($name:ident($first:ident, $second:ident, $third:ident))*) => {$(
        impl<T: Serialize> Serialize for $name<T> {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                [&self.$first, &self.$second, &self.$third].serialize(serializer)
            }
        }

        impl<'de, T: Deserialize<'de>> Deserialize<'de> for $name<T> {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                <[T; 3]>::deserialize(deserializer).map(Self::from)
            }
        }
    )*};
}

array!(Vec3(x, y, z) Rgb(red, green, blue));

/// Implements serialisation of a type as another type.
macro_rules! written_as {
    ($($name:ident($as:ty, $from:expr, $to:expr))*) => {$(
        impl Serialize for $name {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                $to(*self).serialize(serializer)
            }
        }

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                <$as>::deserialize(deserializer).map($from)
            }
        }
    )*};
}

written_as! {
    Rgb565(u16, Self, u16::from)
    Angle(f32, Self::degrees, Self::to_degrees)
    HalfAngle(f32, Self::degrees, Self::to_degrees)
}

/// Implements serialisation of numbers as the integers that store them.
#[cfg(feature = "fixed")]
macro_rules! bits {
    ($($number:ident($bits:ty))*) => {
        written_as!($($number($bits, Self::from_bits, Self::to_bits))*);
    };
}

#[cfg(feature = "fixed")]
for_numbers!(bits);

#[cfg(test)]
mod tests {
    use super::*;
    use core::fmt::Debug;
    use serde_json::{from_str, to_string};

    extern crate std;
    use std::string::ToString;

    /// Checks that a value is serialised as this text, and that this text is read back as the
    /// value.
    fn there_and_back<T: Serialize + for<'de> Deserialize<'de> + PartialEq + Debug>(value: T, text: &str) {
        assert_eq!(to_string(&value).unwrap(), text);
        assert_eq!(from_str::<T>(text).unwrap(), value);
    }

    fn refusal<T: for<'de> Deserialize<'de> + Debug>(text: &str) -> std::string::String {
        from_str::<T>(text).unwrap_err().to_string()
    }

    #[test]
    fn vectors_and_colours_are_arrays() {
        there_and_back(Vec3::new(1.0, -2.5, 0.1_f32), "[1.0,-2.5,0.1]");
        there_and_back(Rgb::new(255_u8, 128, 0), "[255,128,0]");
    }

    #[test]
    fn angles_are_degrees_full_or_half() {
        there_and_back(Angle::degrees(36.5), "36.5");
        there_and_back(HalfAngle::degrees(36.5), "36.5");
        // The constructors accept any angle; the cones reject invalid ones.
        there_and_back(Angle::degrees(-1.0), "-1.0");
    }

    #[test]
    fn pixels_are_sixteen_bits() {
        there_and_back(Rgb565(0xf81f), "63519");
    }

    #[cfg(feature = "fixed")]
    #[test]
    fn numbers_are_their_bits() {
        there_and_back(Fx16::ONE, "16384");
        there_and_back(Fx16::point([1.0, -2.0, 0.5]), "[65536,-131072,32768]");
        macro_rules! check {
            ($($number:ident($bits:ty))*) => {$(
                for bits in [0, 1, <$bits>::MIN, <$bits>::MAX] {
                    there_and_back($number::from_bits(bits), &bits.to_string());
                }
            )*};
        }
        for_numbers!(check);
    }

    #[test]
    fn what_is_no_such_value_is_refused() {
        assert!(
            refusal::<Vec3<f32>>("[1.0,2.0]").contains("invalid length 2, expected an array of length 3")
        );
        assert!(refusal::<Rgb<u8>>("[1,2,3,4]").contains("trailing characters"));
        assert!(refusal::<Rgb<u8>>("[1,2,256]").contains("integer `256`, expected u8"));
        assert!(refusal::<Rgb565>("65536").contains("integer `65536`, expected u16"));
        assert!(refusal::<Angle>("null").contains("invalid type: null, expected f32"));
        #[cfg(feature = "fixed")]
        assert!(refusal::<Fx16>("32768").contains("integer `32768`, expected i16"));
        #[cfg(feature = "fixed")]
        assert!(refusal::<Fx16>("0.5").contains("floating point `0.5`, expected i16"));
    }
}
