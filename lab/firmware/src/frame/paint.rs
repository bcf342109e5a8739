//! The stages from a visible point to its pixel: light, colour, display.

use luminaire::number::Light16;
use luminaire::{
    Fx16, Rgb,
    display::{Rgb565, clip},
    falloff::Soft,
    light::QuickSpotLight,
};

use super::WIDTH;
use super::scene::Site;

/// Light of three channels.
pub(super) type Color = Rgb<Light16>;

/// The light, computed by the build script.
pub(super) const KEY: QuickSpotLight<Fx16, Soft> = include!(concat!(env!("OUT_DIR"), "/frame_key.rs"));
/// The ambient light that each material reflects.
pub(super) const GLOW: [Color; 5] = include!(concat!(env!("OUT_DIR"), "/frame_glow.rs"));
/// The product of each material's colour and the spotlight's.
const TINT: [Rgb<Fx16>; 5] = include!(concat!(env!("OUT_DIR"), "/frame_tint.rs"));

/// The pixels of surfaces that receive ambient light only: for each material, a cell of the dither.
pub(super) struct Ambient([[[Rgb565; 8]; 8]; 5]);

impl Ambient {
    pub(super) fn new() -> Self {
        let mut pixels = [[[Rgb565::default(); 8]; 8]; 5];
        for (cell, glow) in pixels.iter_mut().zip(GLOW) {
            for (y, row) in (0..).zip(cell) {
                for (x, pixel) in (0..).zip(row) {
                    *pixel = Rgb565::from_linear_dithered_fast(clip::<Fx16>(glow), x, y);
                }
            }
        }
        Self(pixels)
    }

    /// Paints all pixels of a row as if the spotlight did not reach them.
    #[inline(never)]
    pub(super) fn paint(&self, sites: &[Site; WIDTH], row: usize, pixels: &mut [Rgb565; WIDTH]) {
        for (column, pixel) in pixels.iter_mut().enumerate() {
            *pixel = self.0[sites[column].material as usize][row % 8][column % 8];
        }
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

/// The reflected light of the sites that the spotlight reaches: the ambient light's and the
/// spotlight's.
#[inline(never)]
pub(super) fn color(sites: &[Site; WIDTH], lights: &[Light16; WIDTH], colors: &mut [Color; WIDTH]) {
    for (column, color) in colors.iter_mut().enumerate() {
        let (material, light) = (sites[column].material as usize, lights[column]);
        if light != Light16::ZERO {
            *color = GLOW[material].plus::<Fx16>(Rgb::lit(light, TINT[material]));
        }
    }
}

/// The pixels that the spotlight reaches.
#[inline(never)]
pub(super) fn display(
    lights: &[Light16; WIDTH],
    colors: &[Color; WIDTH],
    row: usize,
    pixels: &mut [Rgb565; WIDTH],
) {
    for (column, pixel) in pixels.iter_mut().enumerate() {
        if lights[column] != Light16::ZERO {
            let color = clip::<Fx16>(colors[column]);
            *pixel = Rgb565::from_linear_dithered_fast(color, column as u32, row as u32);
        }
    }
}
