//! The irradiance of a spotlight with a soft edge, Lambert's cosine and the inverse-square law, cut off at a range.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::spot_soft_lambert_hard_range);
