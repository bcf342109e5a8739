//! The irradiance of a spotlight with a soft edge under a shadow map of 16 by 16: Lambert's cosine, no fall with distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::Scalar;
use luminaire_effects::{
    Format, Surface,
    constants::{SHADOW, SPOT_SOFT},
};

luminaire_effects::program!(|surface: Surface| {
    let Surface { point, normal, .. } = surface;
    Format::filter(SPOT_SOFT.irradiance(point, normal), SHADOW.visibility(point))
});
