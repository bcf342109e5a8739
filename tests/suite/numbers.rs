//! The types of the fixed-point numbers, which wrap types of the crate `fixed`.

use fixed::types::{I2F14, I2F30, I16F16, U18F14};
use luminaire::{Fx16, Fx32, Length, Vec3, number::Light16};

#[test]
fn numbers_convert_to_fixed_and_back_with_their_bits() {
    for bits in i16::MIN..=i16::MAX {
        let (number, fixed) = (Fx16::from_bits(bits), I2F14::from_bits(bits));
        assert_eq!((I2F14::from(number), Fx16::from(fixed)), (fixed, number));
        assert_eq!((number.to_f32(), number.to_f64()), (fixed.to_num(), fixed.to_num()));
        assert_eq!(
            (number.to_string(), format!("{number:.3?}")),
            (fixed.to_string(), format!("{fixed:.3?}"))
        );
    }
    for bits in [i32::MIN, -65_537, -1, 0, 1, 98_765_432, i32::MAX] {
        let (length, fixed) = (Length::from_bits(bits), I16F16::from_bits(bits));
        assert_eq!(
            (I16F16::from(length), length.to_f32(), length.to_f64()),
            (fixed, fixed.to_num(), fixed.to_num())
        );
        assert_eq!(Fx32::from_bits(bits).to_f32(), I2F30::from_bits(bits).to_num::<f32>());
        let light = bits.cast_unsigned();
        assert_eq!(Light16::from_bits(light).to_f32(), U18F14::from_bits(light).to_num::<f32>());
    }
}

#[test]
fn constants_are_those_of_the_bits() {
    assert_eq!(
        (Fx16::ONE.to_bits(), Fx32::ONE.to_bits(), Length::ONE.to_bits()),
        (1 << 14, 1 << 30, 1 << 16)
    );
    assert_eq!((Fx16::MIN.to_f32(), Fx16::MAX.to_bits(), Fx16::ZERO.to_bits()), (-2.0, i16::MAX, 0));
    assert_eq!([Length::from_int(-3), Length::from_int(i16::MAX)].map(Length::to_f32), [-3.0, 32_767.0]);
    assert_eq!(Fx16::MAX.saturating_add(Fx16::ONE), Fx16::MAX);
    assert_eq!(Fx16::MIN.saturating_sub(Fx16::ONE), Fx16::MIN);
}

#[test]
fn points_and_normals_are_constants_of_nearest_numbers() {
    const POINT: Vec3<Length> = Fx16::point([0.343, -1.0, 40_000.0]);
    const NORMAL: Vec3<Fx16> = Fx16::normal([0.6, f32::NAN, -3.0]);
    assert_eq!(<[_; 3]>::from(POINT), [Length::from_bits(22_479), Length::from_int(-1), Length::MAX]);
    assert_eq!(<[_; 3]>::from(NORMAL), [Fx16::from_bits(9_830), Fx16::ZERO, Fx16::MIN]);
    assert_eq!(Fx32::point([1.0, 2.0, 3.0]), Vec3::from([1, 2, 3].map(Length::from_int)));
    assert_eq!(Fx32::normal([1.0, 0.0, -1.0]).z.to_bits(), -1 << 30);
}
