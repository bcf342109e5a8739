//! Conversions from and to types of other crates. Each conversion needs the feature named like the
//! crate, with the crate's version if that is not yet 1.0.
//!
//! | feature | [`Vec3`](crate::Vec3) | [`Rgb`](crate::Rgb) | [`Rgb565`](crate::display::Rgb565) | [`Angle`](crate::Angle), [`HalfAngle`](crate::HalfAngle) | fixed-point numbers |
//! |---|---|---|---|---|---|
//! | `bytemuck` | `Pod` | `Pod` | `Pod` | | `Pod` |
//! | `defmt` | `Format` | `Format` | `Format` | `Format` | `Format` |
//! | `embedded-graphics-core04` | | `Rgb888`, `Bgr888` | `Rgb565`, `Bgr565`, and other pixels | | |
//! | `glam034` | `Vec3` | `Vec3` | | | |
//! | `mint05` | `Vector3`, `Point3` | `Vector3` | | | |
//! | `serde` | array | array | 16 bits | degrees | their bits |
//!
//! `defmt` also formats an [`Error`](crate::Error), its [`Parameter`](crate::error::Parameter) and
//! the [`Expected`](crate::error::Expected) range. Lights, cones, falloffs and attenuations have
//! `serde` and `defmt`, too. Conversions of [`Vec3`](crate::Vec3) and
//! [`Rgb`](crate::Rgb) from and to arrays of three need no feature.

/// Calls a macro with every fixed-point number type and the integer that stores it.
#[cfg(all(feature = "fixed", any(feature = "bytemuck", feature = "defmt", feature = "serde")))]
macro_rules! for_numbers {
    ($then:ident) => {
        $then! {
            Fx16(i16) Fx32(i32) Length(i32) Light16(u32) Light32(u64) Versine(u32) Weight16(i32)
            Weight32(i64)
        }
    };
}

#[cfg(feature = "bytemuck")]
pub mod bytemuck;
#[cfg(feature = "defmt")]
pub mod defmt;
#[cfg(feature = "embedded-graphics-core04")]
pub mod embedded_graphics;
#[cfg(feature = "glam034")]
pub mod glam;
#[cfg(feature = "mint05")]
pub mod mint;
#[cfg(feature = "serde")]
pub mod serde;

#[cfg(test)]
mod tests {
    use crate::{color::Rgb, display::Rgb565, vec3::Vec3};

    #[test]
    fn arrays_become_vectors_and_colours_and_come_back() {
        assert_eq!(Vec3::from([1, 2, 3]), Vec3::new(1, 2, 3));
        assert_eq!(<[u8; 3]>::from(Vec3::new(1, 2, 3)), [1, 2, 3]);
        assert_eq!(Rgb::from([1, 2, 3]), Rgb::new(1, 2, 3));
        assert_eq!(<[u8; 3]>::from(Rgb::new(1, 2, 3)), [1, 2, 3]);
    }

    #[test]
    fn a_pixel_has_red_in_the_upper_bits_and_in_the_first_byte() {
        let red = Rgb565::from_codes(Rgb::new(255, 0, 0));
        assert_eq!((u16::from(red), red.to_be_bytes()), (0xf800, [0xf8, 0]));
        let blue = Rgb565::from_codes(Rgb::new(0, 0, 255));
        assert_eq!((u16::from(blue), blue.to_be_bytes()), (0x001f, [0, 0x1f]));
        assert_eq!(Rgb565::from(0xf800), red);
    }
}
