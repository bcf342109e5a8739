//! The soft spotlight with further effects that constants switch off: they must add no bytes.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::{
    Rgb,
    display::{clip, encode_srgb},
    falloff::{Soft, Table},
    specular::Phong,
};
use luminaire_effects::constants::{AMBIENT, EXPOSURE, POINT};
use luminaire_effects::{Light, Listed, Surface};

luminaire_effects::program!(|surface: Surface| {
    if IS_GLOSSY {
        show(Phong::CONSTANT.glow(AMBIENT) + Phong::CONSTANT.reflect(&surface, &POINT));
    }
    if HAS_FLOOD {
        show(Rgb::lit(Table::CONSTANT.irradiance(surface.point, surface.normal), Table::CONSTANT.color()));
    }
    Soft::CONSTANT.irradiance(surface.point, surface.normal)
});

/// Whether the scene requires a glossy surface, and a second light.
const IS_GLOSSY: bool = false;
const HAS_FLOOD: bool = false;

/// Writes a pixel to where a display would be.
#[inline(never)]
fn show(light: Light) {
    core::hint::black_box(clip(EXPOSURE.expose(light)).map(encode_srgb));
}
