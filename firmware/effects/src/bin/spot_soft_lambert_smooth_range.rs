//! The irradiance of a spotlight with a soft edge, Lambert's cosine and a smoothstep to a range.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_SMOOTH_RANGE};

luminaire_effects::program!(|surface: Surface| SPOT_SMOOTH_RANGE.irradiance(surface.point, surface.normal));
