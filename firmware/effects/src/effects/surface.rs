//! Other lights, and what surfaces send back.

use crate::constants::{AMBIENT, BLINN_PHONG, DIRECTIONAL, DUAL_CONE, LYON, MATTE, PHONG, POINT};
use crate::{Format, Irradiance, Light, Surface};

/// Ambient light on a matt surface, beside the light of lamps.
#[inline(always)]
pub fn ambient(lamps: Light) -> Light {
    lamps.plus::<Format>(MATTE.glow(AMBIENT))
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

macro_rules! surfaces {
    ($($(#[$meta:meta])* $name:ident = $material:ident;)*) => {$(
        $(#[$meta])*
        #[inline(always)]
        pub fn $name(surface: Surface) -> Light {
            $material.reflect(&surface, &DIRECTIONAL)
        }
    )*};
}

surfaces! {
    /// A matt surface under a directional light, in colours.
    matte = MATTE;
    /// The same with Phong's highlight, of a shininess of 32.
    phong = PHONG;
    /// The same with Blinn's form of Phong's highlight.
    blinn_phong = BLINN_PHONG;
    /// The same with the dual-cone highlight.
    dual_cone = DUAL_CONE;
    /// The same with Lyon's form of Phong's highlight by three squarings.
    lyon = LYON;
}
