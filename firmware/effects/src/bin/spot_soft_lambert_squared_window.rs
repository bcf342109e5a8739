//! The irradiance of a spotlight with a soft edge, Lambert's cosine and the inverse-square law in the squared window.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_SQUARED_WINDOW};

luminaire_effects::program!(|surface: Surface| SPOT_SQUARED_WINDOW.irradiance(surface.point, surface.normal));
