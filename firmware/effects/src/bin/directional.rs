//! The irradiance of a directional light: Lambert's cosine.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::directional);
