//! The irradiance of a spotlight with a soft edge, Lambert's cosine and the capped reciprocal of a polynomial in the distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Surface, constants::SPOT_POLYNOMIAL};

luminaire_effects::program!(|surface: Surface| SPOT_POLYNOMIAL.irradiance(surface.point, surface.normal));
