//! The stages from a visible point to its pixel: light, colour, display.

use luminaire::number::Light16;
use luminaire::{
    Fx16, Rgb,
    display::{Rgb565, clip},
    falloff::Soft,
    light::CompiledSpotLight,
};

use super::WIDTH;
use super::scene::Site;

/// Light of three channels.
pub(super) type Color = Rgb<Light16>;

/// The light, computed by the build script.
pub(super) const KEY: CompiledSpotLight<Fx16, Soft> = include!(concat!(env!("OUT_DIR"), "/frame_key.rs"));
/// The ambient light that each material reflects.
const GLOW: [Color; 5] = include!(concat!(env!("OUT_DIR"), "/frame_glow.rs"));
/// The product of each material's colour and the spotlight's.
const TINT: [Rgb<Fx16>; 5] = include!(concat!(env!("OUT_DIR"), "/frame_tint.rs"));

/// The ambient light of each pixel, and nothing else.
#[inline(never)]
pub(super) fn glow(sites: &[Site; WIDTH], colors: &mut [Color; WIDTH]) {
    for (column, color) in colors.iter_mut().enumerate() {
        *color = GLOW[sites[column].material as usize];
    }
}

/// The irradiance from the spotlight, before its colour.
#[inline(never)]
pub(super) fn light(sites: &[Site; WIDTH], lights: &mut [Light16; WIDTH]) {
    for (column, light) in lights.iter_mut().enumerate() {
        let Site { point, normal, .. } = sites[column];
        *light = KEY.irradiance(point, normal);
    }
}

/// The reflected light: the ambient light's and the spotlight's.
#[inline(never)]
pub(super) fn color(sites: &[Site; WIDTH], lights: &[Light16; WIDTH], colors: &mut [Color; WIDTH]) {
    for (column, color) in colors.iter_mut().enumerate() {
        let (material, light) = (sites[column].material as usize, lights[column]);
        *color = GLOW[material];
        if light != Light16::ZERO {
            *color = color.plus::<Fx16>(Rgb::lit(light, TINT[material]));
        }
    }
}

/// The pixels of a row.
#[inline(never)]
pub(super) fn display(colors: &[Color; WIDTH], row: usize, pixels: &mut [u16; WIDTH]) {
    for (column, pixel) in pixels.iter_mut().enumerate() {
        let color = clip::<Fx16>(colors[column]);
        *pixel = Rgb565::from_linear_dithered(color, column as u32, row as u32).0;
    }
}
