//! Pixels of a display.

use luminaire::{
    Fx16,
    display::{Rgb565, clip, encode_srgb},
};

use crate::luminaire_light;

/// Returns the sum of two lights. It saturates.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_add(a: luminaire_light, b: luminaire_light) -> luminaire_light {
    luminaire_light::of(a.sum().plus::<Fx16>(b.sum()))
}

/// Returns light reflected by a surface of a linear colour, in steps of 2^-14 from 0 to 2^14.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_reflect(
    light: luminaire_light,
    red: i16,
    green: i16,
    blue: i16,
) -> luminaire_light {
    let color = luminaire::Rgb::new(red, green, blue).map(Fx16::from_bits);
    luminaire_light::of(light.sum().filtered::<Fx16>(color))
}

/// Returns a pixel of RGB565, clipped at full scale.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_rgb565(light: luminaire_light) -> u16 {
    Rgb565::from_linear(clip::<Fx16>(light.sum())).0
}

/// Returns a pixel of RGB565 at `(x, y)` with ordered dither, clipped at full scale.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_rgb565_dithered(light: luminaire_light, x: u32, y: u32) -> u16 {
    Rgb565::from_linear_dithered(clip::<Fx16>(light.sum()), x, y).0
}

/// Returns a pixel of three sRGB codes, `0xRRGGBB`, clipped at full scale.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_srgb(light: luminaire_light) -> u32 {
    let codes = clip::<Fx16>(light.sum()).map(|channel| u32::from(encode_srgb(channel)));
    codes.red << 16 | codes.green << 8 | codes.blue
}
