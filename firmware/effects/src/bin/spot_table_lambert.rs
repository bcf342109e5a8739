//! The irradiance of a spotlight with a table of 16 samples for an edge: Lambert's cosine, no fall with distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_TABLE};

luminaire_effects::program!(|surface: Surface| SPOT_TABLE.irradiance(surface.point, surface.normal));
