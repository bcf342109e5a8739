//! The irradiance of a spotlight with the eighth power for an edge: Lambert's cosine, no fall with distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_POWER};

luminaire_effects::program!(|surface: Surface| SPOT_POWER.irradiance(surface.point, surface.normal));
