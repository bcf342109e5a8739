//! The irradiance of a point light: the inverse-square law and Lambert's cosine.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::point);
