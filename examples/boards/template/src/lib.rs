#![no_std]

use luminaire::{
    Fx16, Length, Rgb, Vec3,
    display::{Rgb565, clip},
    falloff::Soft,
    light::CompiledSpotLight,
};

static LIGHTS: [CompiledSpotLight<Fx16, Soft>; 2] = include!(concat!(env!("OUT_DIR"), "/lights.rs"));

/// One row of a wall that faces the lights, 32 pixels to the metre.
pub fn scanline(row: i32, pixels: &mut [u16]) {
    const NORMAL: Vec3<Fx16> = Fx16::normal([0.0, 0.0, 1.0]);
    let metres = |pixels: i32| Length::from_bits(pixels << (16 - 5)); // 16 fraction bits
    for (column, pixel) in (0..).zip(pixels) {
        let point = Vec3::new(metres(column), metres(row), Length::ZERO);
        let mut sum = Rgb::default();
        for light in &LIGHTS {
            sum += Rgb::lit(light.irradiance(point, NORMAL), light.color());
        }
        // Most displays take the high byte first.
        *pixel = Rgb565::from_linear(clip(sum)).0.to_be();
    }
}
