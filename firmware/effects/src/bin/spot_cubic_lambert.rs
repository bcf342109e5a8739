//! The irradiance of a spotlight with a cubic edge: Lambert's cosine, no fall with distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_CUBIC};

luminaire_effects::program!(|surface: Surface| SPOT_CUBIC.irradiance(surface.point, surface.normal));
