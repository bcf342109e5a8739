//! The same with the eighth power.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_POWER};

luminaire_effects::program!(|surface: Surface| SPOT_POWER.irradiance(surface.point, surface.normal));
