//! The irradiance of a spotlight with the fourth power of the rim for an edge: Lambert's cosine, no fall with distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::spot_rim_lambert);
