//! The same with a hard edge.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_HARD};

luminaire_effects::program!(|surface: Surface| SPOT_HARD.irradiance(surface.point, surface.normal));
