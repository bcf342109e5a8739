//! The irradiance of a spotlight with a soft edge, Lambert's cosine and the inverse-square law, cut off at a range.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_HARD_RANGE};

luminaire_effects::program!(|surface: Surface| SPOT_HARD_RANGE.irradiance(surface.point, surface.normal));
