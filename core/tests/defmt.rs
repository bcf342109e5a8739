//! What `defmt` sends: a logger on the host keeps the bytes. It needs unsafe code, which the crate itself forbids.

use std::sync::Mutex;

use luminaire::{
    Angle, Cone, Fx16, HalfAngle, Rgb, SpotLight, Vec3,
    display::Rgb565,
    error::{Expected, Parameter},
    falloff::Soft,
    number::Light32,
};

/// What has been sent.
static SENT: Mutex<Vec<u8>> = Mutex::new(Vec::new());

/// A logger that keeps all bytes.
#[defmt::global_logger]
struct Keeper;

// SAFETY: the bytes are behind a lock. There is one test, so that no two frames meet.
unsafe impl defmt::Logger for Keeper {
    fn acquire() {}

    unsafe fn flush() {}

    unsafe fn release() {}

    unsafe fn write(bytes: &[u8]) {
        SENT.lock().unwrap().extend(bytes);
    }
}

defmt::timestamp!("");

/// The bytes of a value, with those of the addresses of format strings between them.
fn sent(value: impl defmt::Format) -> Vec<u8> {
    SENT.lock().unwrap().clear();
    defmt::println!("{}", value);
    SENT.lock().unwrap().clone()
}

/// Asserts that a value is sent as these parts, in this order.
fn assert_sent<const N: usize, const M: usize>(value: impl defmt::Format, parts: [[u8; M]; N]) {
    let sent = sent(value);
    let mut rest = &sent[..];
    for part in parts {
        let at = rest.windows(M).position(|window| window == part);
        let at = at.unwrap_or_else(|| panic!("{part:?} is not in the rest, {rest:?}, of {sent:?}"));
        rest = &rest[at + M..];
    }
}

#[test]
fn values_are_sent_in_order_and_raw() {
    let floats = |values: [f32; 3]| values.map(f32::to_le_bytes);
    assert_sent(Angle::degrees(36.5), [36.5_f32.to_le_bytes()]);
    assert_sent(HalfAngle::degrees(18.25), [18.25_f32.to_le_bytes()]);
    assert_sent(Vec3::new(1.5_f32, -2.25, 3.125), floats([1.5, -2.25, 3.125]));
    assert_sent(Rgb::new(1.5_f32, 0.625, 0.375), floats([1.5, 0.625, 0.375]));
    assert_sent(Rgb565(0xabcd), [0xabcd_u16.to_le_bytes()]);
    let refused = Cone::from_field(Soft, Angle::degrees(400.0)).unwrap_err();
    let Expected::AngleUpTo(most) = refused.accepted else { panic!("{refused}") };
    assert_sent(refused, [400.0_f32.to_le_bytes(), most.to_le_bytes()]);
    assert_sent(Fx16::point([0.375, -5.5, 1e-9]), floats([0.375, -5.5, 0.0]));
    assert_sent(Fx16::MIN, [(-2.0_f32).to_le_bytes()]);
    assert_sent(Light32::MAX, [2_f32.powi(34).to_le_bytes()]);
    let cone = Cone::from_outer(Soft, Angle::degrees(180.0)).unwrap();
    let spot = SpotLight::new([0.5, 4.0, 0.25], [0.0, -2.0, 0.0], cone).unwrap().with_intensity(7.0).unwrap();
    assert_sent(spot, [0.5, 4.0, 0.25, -1.0, 0.0, 1.0, 1.0, 7.0].map(f32::to_le_bytes));
    // Variants are sent by their place.
    assert_eq!(sent(Parameter::FieldAngle).last(), Some(&1));
}
