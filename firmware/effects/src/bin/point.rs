//! The irradiance of a point light: the inverse-square law and Lambert's cosine.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::POINT};

luminaire_effects::program!(|surface: Surface| POINT.irradiance(surface.point, surface.normal));
