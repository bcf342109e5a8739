//! The soft spotlight again, beside other effects that its scene might have called for and does not: they cost nothing.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::{
    Rgb,
    display::{clip, encode_srgb},
};
use luminaire_effects::constants::{AMBIENT, EXPOSURE, PHONG, POINT, SPOT_SOFT, SPOT_TABLE};
use luminaire_effects::{Format, Light, Surface};

luminaire_effects::program!(|surface: Surface| {
    if IS_GLOSSY {
        show(PHONG.glow(AMBIENT).plus::<Format>(PHONG.reflect(&surface, &POINT)));
    }
    if HAS_FLOOD {
        show(Rgb::lit(SPOT_TABLE.irradiance(surface.point, surface.normal), SPOT_TABLE.color()));
    }
    SPOT_SOFT.irradiance(surface.point, surface.normal)
});

/// What the scene calls for.
const IS_GLOSSY: bool = false;
const HAS_FLOOD: bool = false;

/// Writes a pixel to where a display would be.
#[inline(never)]
fn show(light: Light) {
    core::hint::black_box(clip::<Format>(EXPOSURE.expose(light)).map(encode_srgb));
}
