//! The irradiance of a directional light: Lambert's cosine.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::DIRECTIONAL};

luminaire_effects::program!(|surface: Surface| DIRECTIONAL.irradiance(surface.normal));
