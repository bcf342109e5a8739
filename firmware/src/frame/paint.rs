//! From what a pixel sees to the pixel: light, colour, display.

use luminaire::source::U18F14;
use luminaire::{CompiledSpot, Fx16, Rgb, Rgb565, Soft, clip};

use super::WIDTH;
use super::scene::Site;

/// Light of three channels.
pub(super) type Color = Rgb<U18F14>;

/// The lamp, computed by the build script.
pub(super) const KEY: CompiledSpot<Fx16, Soft> = include!(concat!(env!("OUT_DIR"), "/frame_key.rs"));
/// What each material sends back of the ambient light.
const GLOW: [Color; 5] = include!(concat!(env!("OUT_DIR"), "/frame_glow.rs"));
/// What each material sends back of the lamp's, the lamp's colour included.
const TINT: [Rgb<Fx16>; 5] = include!(concat!(env!("OUT_DIR"), "/frame_tint.rs"));

/// The ambient light of each pixel, and nothing else.
#[inline(never)]
pub(super) fn glow(sites: &[Site; WIDTH], colors: &mut [Color; WIDTH]) {
    for (site, color) in sites.iter().zip(colors) {
        *color = GLOW[site.material as usize];
    }
}

/// What arrives of the lamp, before its colour.
#[inline(never)]
pub(super) fn light(sites: &[Site; WIDTH], lights: &mut [U18F14; WIDTH]) {
    for (site, light) in sites.iter().zip(lights) {
        *light = KEY.irradiance(site.point, site.normal);
    }
}

/// The ambient light and the lamp's, as the materials send them back.
#[inline(never)]
pub(super) fn color(sites: &[Site; WIDTH], lights: &[U18F14; WIDTH], colors: &mut [Color; WIDTH]) {
    for ((site, light), color) in sites.iter().zip(lights).zip(colors) {
        let glow = GLOW[site.material as usize];
        let is_lit = *light != U18F14::ZERO;
        let lit = || glow.plus::<Fx16>(Rgb::lit(*light, TINT[site.material as usize]));
        *color = if is_lit { lit() } else { glow };
    }
}

/// The pixels of a row.
#[inline(never)]
pub(super) fn display(colors: &[Color; WIDTH], row: usize, pixels: &mut [u16; WIDTH]) {
    for ((column, color), pixel) in (0..).zip(colors).zip(pixels) {
        *pixel = Rgb565::from_linear_dithered(clip::<Fx16>(*color), column, row as u32).0;
    }
}
