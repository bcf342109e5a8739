//! Lights other than spotlights, and light that surfaces reflect.

use crate::constants::{AMBIENT, DIRECTIONAL, MATTE, POINT};
use crate::{Format, Irradiance, Light, Surface};

list! {
    surface: directional point matte;
    light: ambient;
}

/// Light of other lights, plus the ambient light that a matte surface reflects.
#[inline(always)]
pub fn ambient(lights: Light) -> Light {
    lights.plus::<Format>(MATTE.glow(AMBIENT))
}

/// The irradiance of a directional light: Lambert's cosine.
#[inline(always)]
pub fn directional(surface: Surface) -> Irradiance {
    DIRECTIONAL.irradiance(surface.normal)
}

/// The irradiance of a point light: the inverse-square law and Lambert's cosine.
#[inline(always)]
pub fn point(surface: Surface) -> Irradiance {
    POINT.irradiance(surface.point, surface.normal)
}

/// A matte surface under a directional light, in colours.
#[inline(always)]
pub fn matte(surface: Surface) -> Light {
    MATTE.reflect(&surface, &DIRECTIONAL)
}
