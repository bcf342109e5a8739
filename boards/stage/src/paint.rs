//! The stages from a visible point to its pixel: light, colour, display.

use luminaire::number::Light16;
use luminaire::{
    Fx16, Rgb,
    display::{Rgb565, clip},
    falloff::Soft,
    light::QuickSpotLight,
};

use super::scene::Site;

/// Light of three channels.
pub(super) type Color = Rgb<Light16>;

/// The kind of the light: a soft spotlight in 16 bits, by the quick evaluation.
pub(super) type Key = QuickSpotLight<Fx16, Soft>;

/// The light, compiled by the build script.
pub(super) const KEY: Key = include!(concat!(env!("OUT_DIR"), "/key.rs"));
/// The ambient light that each material reflects.
pub(super) const GLOW: [Color; 5] = include!(concat!(env!("OUT_DIR"), "/glow.rs"));
/// The product of each material's colour and the spotlight's.
const TINT: [Rgb<Fx16>; 5] = include!(concat!(env!("OUT_DIR"), "/tint.rs"));

/// The pixels of surfaces that receive ambient light only: for each material, a cell of the dither.
#[derive(Debug)]
pub(super) struct Ambient([[[u16; 8]; 8]; 5]);

impl Ambient {
    pub(super) fn new() -> Self {
        let mut pixels = [[[0; 8]; 8]; 5];
        for (cell, glow) in pixels.iter_mut().zip(GLOW) {
            for (y, row) in (0..).zip(cell) {
                for (x, pixel) in (0..).zip(row) {
                    *pixel = Rgb565::from_linear_dithered_fast(clip::<Fx16>(glow), x, y).0;
                }
            }
        }
        Self(pixels)
    }

    /// Paints all pixels of a row as if the spotlight did not reach them.
    #[inline(never)]
    pub(super) fn paint<const WIDTH: usize>(
        &self,
        sites: &[Site; WIDTH],
        row: i32,
        pixels: &mut [u16; WIDTH],
    ) {
        let row = row.cast_unsigned() as usize % 8;
        for (column, (site, pixel)) in sites.iter().zip(pixels).enumerate() {
            *pixel = self.0[site.material as usize][row][column % 8];
        }
    }
}

/// The irradiance from the spotlight, before its colour.
///
/// All pictures share this function, because the compiler inlines the evaluation in one place only.
#[inline(never)]
pub(super) fn light(key: &Key, sites: &[Site], lights: &mut [Light16]) {
    for (site, light) in sites.iter().zip(lights) {
        *light = key.irradiance(site.point, site.normal);
    }
}

/// The reflected light of the sites that the spotlight reaches: the ambient light's and the
/// spotlight's.
#[inline(never)]
pub(super) fn color<const WIDTH: usize>(
    sites: &[Site; WIDTH],
    lights: &[Light16; WIDTH],
    colors: &mut [Color; WIDTH],
) {
    for ((site, &light), color) in sites.iter().zip(lights).zip(colors) {
        if light != Light16::ZERO {
            let material = site.material as usize;
            *color = GLOW[material].plus::<Fx16>(Rgb::lit(light, TINT[material]));
        }
    }
}

/// The pixels that the spotlight reaches.
#[inline(never)]
pub(super) fn display<const WIDTH: usize>(
    lights: &[Light16; WIDTH],
    colors: &[Color; WIDTH],
    row: i32,
    pixels: &mut [u16; WIDTH],
) {
    for (column, ((&light, color), pixel)) in lights.iter().zip(colors).zip(pixels).enumerate() {
        if light != Light16::ZERO {
            let color = clip::<Fx16>(*color);
            *pixel = Rgb565::from_linear_dithered_fast(color, column as u32, row.cast_unsigned()).0;
        }
    }
}
