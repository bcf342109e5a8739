//! The irradiance of a spotlight with a soft edge, Lambert's cosine and the inverse-square law.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_INVERSE_SQUARE};

luminaire_effects::program!(|surface: Surface| SPOT_INVERSE_SQUARE.irradiance(surface.point, surface.normal));
