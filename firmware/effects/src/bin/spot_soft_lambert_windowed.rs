//! The irradiance of a spotlight with a soft edge, Lambert's cosine and the inverse-square law in the window of glTF.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_WINDOWED};

luminaire_effects::program!(|surface: Surface| SPOT_WINDOWED.irradiance(surface.point, surface.normal));
