//! Zero-copy casts between bytes and slices of vectors, colours, pixels and numbers.
//!
//! [`Rgb565`] and the fixed-point numbers are `Pod`: any bits are valid, and there is no padding.
//! [`Vec3`] and [`Rgb`] are `Pod` if their components are `Pod`. The casts give bytes in the
//! processor's byte order; [`Rgb565::to_be_bytes`] gives a fixed byte order. Angles are not `Pod`,
//! because their layout is private.
//!
//! ```
//! use luminaire::{Vec3, display::Rgb565};
//! let vertices = [Vec3::new(0.0_f32, 1.0, 2.0), Vec3::new(3.0, 4.0, 5.0)];
//! assert_eq!(bytemuck::cast_slice::<_, f32>(&vertices), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
//!
//! let mut row = [Rgb565::default(); 160];
//! bytemuck::cast_slice_mut::<_, u16>(&mut row).fill(0xffff);
//! assert_eq!(row[159], Rgb565(0xffff));
//! ```

#![expect(unsafe_code, reason = "to be Pod is a promise that the compiler cannot check")]

#[cfg(feature = "fixed")]
use crate::number::{Fx16, Fx32, Length, Light16, Light32, Versine, Weight16, Weight32};
use crate::{color::Rgb, display::Rgb565, vec3::Vec3};
use bytemuck::{Pod, Zeroable};

// SAFETY: all-zero bits are three `T` of all-zero bits, which are valid.
unsafe impl<T: Zeroable> Zeroable for Vec3<T> {}
// SAFETY: `repr(C)` stores three `T` like an array, without padding, and `T` is valid for any bits.
unsafe impl<T: Pod> Pod for Vec3<T> {}

// SAFETY: all-zero bits are three `T` of all-zero bits, which are valid.
unsafe impl<T: Zeroable> Zeroable for Rgb<T> {}
// SAFETY: `repr(C)` stores three `T` like an array, without padding, and `T` is valid for any bits.
unsafe impl<T: Pod> Pod for Rgb<T> {}

/// Implements `Pod` for types stored as one integer.
macro_rules! pod {
    ($($number:ident($bits:ty))*) => {$(
        // SAFETY: the type is `repr(transparent)` over an integer, and zero is a valid integer.
        unsafe impl Zeroable for $number {}
        // SAFETY: the type is `repr(transparent)` over an integer, and any bits are a valid
        // integer.
        unsafe impl Pod for $number {}
    )*};
}

pod!(Rgb565(u16));
#[cfg(feature = "fixed")]
for_numbers!(pod);

#[cfg(test)]
mod tests {
    use super::*;
    use bytemuck::{bytes_of, cast, cast_slice};

    #[test]
    fn vectors_and_colours_are_their_components_in_order() {
        let vectors = [Vec3::new(1_u16, 2, 3), Vec3::new(4, 5, 6)];
        assert_eq!(cast_slice::<_, u16>(&vectors), [1, 2, 3, 4, 5, 6]);
        assert_eq!(cast::<_, Vec3<u16>>([1_u16, 2, 3]), vectors[0]);
        let colors = [Rgb::new(1_u8, 2, 3), Rgb::new(4, 5, 6)];
        assert_eq!(bytes_of(&colors), [1, 2, 3, 4, 5, 6]);
        assert_eq!(cast::<_, Rgb<f32>>([0.25_f32, 0.5, 1.0]), Rgb::new(0.25, 0.5, 1.0));
        assert_eq!((Vec3::<f32>::zeroed(), Rgb::<u8>::zeroed()), Default::default());
    }

    #[test]
    fn a_pixel_is_its_bits() {
        assert_eq!(bytes_of(&Rgb565(0x1234)), 0x1234_u16.to_ne_bytes());
        assert_eq!(cast::<u16, Rgb565>(0x1234), Rgb565(0x1234));
    }

    #[cfg(feature = "fixed")]
    #[test]
    fn numbers_are_their_bits() {
        macro_rules! check {
            ($($number:ident($bits:ty))*) => {$(
                for bits in [0, 1, <$bits>::MIN, <$bits>::MAX] {
                    let number = $number::from_bits(bits);
                    assert_eq!(bytes_of(&number), bits.to_ne_bytes());
                    assert_eq!(cast::<$bits, $number>(bits), number);
                }
                assert_eq!($number::zeroed(), $number::ZERO);
            )*};
        }
        for_numbers!(check);
        let point = Fx16::point([1.0, -2.0, 0.5]);
        assert_eq!(cast::<_, [i32; 3]>(point), [1 << 16, -2 << 16, 1 << 15]);
    }
}
