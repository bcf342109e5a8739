//! Conversions from and to the types of other crates, each by the feature of its name.

#[cfg(feature = "glam")]
pub mod glam;

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
    fn a_pixel_has_red_in_the_upper_bits_and_either_order_of_bytes() {
        let red = Rgb565::from_codes(Rgb::new(255, 0, 0));
        assert_eq!((u16::from(red), red.to_be_bytes(), red.to_le_bytes()), (0xf800, [0xf8, 0], [0, 0xf8]));
        let blue = Rgb565::from_codes(Rgb::new(0, 0, 255));
        assert_eq!((u16::from(blue), blue.to_be_bytes(), blue.to_le_bytes()), (0x001f, [0, 0x1f], [0x1f, 0]));
        assert_eq!(Rgb565::from(0xf800), red);
    }
}
