//! The irradiance of a spotlight with a soft edge under a shadow map of 16 by 16: Lambert's cosine, no fall with distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::spot_soft_lambert_shadow);
