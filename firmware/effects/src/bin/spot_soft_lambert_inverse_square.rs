//! The soft spotlight with the inverse-square law.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_INVERSE_SQUARE};

luminaire_effects::program!(|surface: Surface| SPOT_INVERSE_SQUARE.irradiance(surface.point, surface.normal));
