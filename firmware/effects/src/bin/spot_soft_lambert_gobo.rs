//! The irradiance of a spotlight with a soft edge behind a gobo of 16 by 16: Lambert's cosine, no fall with distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{
    Surface,
    constants::{GOBO, SPOT_SOFT},
};

luminaire_effects::program!(|surface: Surface| {
    let Surface { point, normal, .. } = surface;
    GOBO.filter(SPOT_SOFT.irradiance(point, normal), point)
});
