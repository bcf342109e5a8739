//! The irradiance of a spotlight with a straight ramp for an edge: Lambert's cosine, no fall with distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::spot_linear_lambert);
