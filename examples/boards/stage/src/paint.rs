//! The stages from a visible point to its pixel: light and display.

use luminaire::number::Light16;
use luminaire::{Fx16, display::Rgb565Ramp, falloff::Soft, light::QuickSpotLight};

use super::site::Site;

/// The kind of the light: a soft spotlight in 16 bits, by the quick evaluation.
pub(super) type Key = QuickSpotLight<Fx16, Soft>;

/// The light, compiled by the build script.
pub(super) const KEY: Key = include!(concat!(env!("OUT_DIR"), "/key.rs"));
/// The pixels of each material by the light's irradiance, with the ambient light that it reflects.
pub(super) static RAMPS: [Rgb565Ramp; 5] = include!(concat!(env!("OUT_DIR"), "/ramps.rs"));

/// The pixels of surfaces that receive ambient light only: for each material, a cell of the dither.
#[derive(Debug)]
pub(super) struct Ambient([[[u16; 8]; 8]; 5]);

impl Ambient {
    pub(super) fn new() -> Self {
        let mut pixels = [[[0; 8]; 8]; 5];
        for (cell, ramp) in pixels.iter_mut().zip(&RAMPS) {
            for (y, row) in (0..).zip(cell) {
                for (x, pixel) in (0..).zip(row) {
                    *pixel = ramp.pixel::<Fx16>(Light16::ZERO, x, y).0;
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

/// The pixels that the spotlight reaches.
#[inline(never)]
pub(super) fn display<const WIDTH: usize>(
    sites: &[Site; WIDTH],
    lights: &[Light16; WIDTH],
    row: i32,
    pixels: &mut [u16; WIDTH],
) {
    for (column, ((site, &light), pixel)) in sites.iter().zip(lights).zip(pixels).enumerate() {
        if light != Light16::ZERO {
            let ramp = &RAMPS[site.material as usize];
            *pixel = ramp.pixel::<Fx16>(light, column as u32, row.cast_unsigned()).0;
        }
    }
}
