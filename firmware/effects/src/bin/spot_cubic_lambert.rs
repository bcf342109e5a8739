//! The same with a cubic.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_CUBIC};

luminaire_effects::program!(|surface: Surface| SPOT_CUBIC.irradiance(surface.point, surface.normal));
