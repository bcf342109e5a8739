//! The irradiance of a spotlight with a soft edge: Lambert's cosine, no fall with distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_SOFT};

luminaire_effects::program!(|surface: Surface| SPOT_SOFT.irradiance(surface.point, surface.normal));
