//! The irradiance of a spotlight with a smooth edge: Lambert's cosine, no fall with distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_SMOOTH};

luminaire_effects::program!(|surface: Surface| SPOT_SMOOTH.irradiance(surface.point, surface.normal));
