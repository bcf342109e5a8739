//! The irradiance of a spotlight with a soft edge, Lambert's cosine and the inverse-square law in the window of glTF.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::spot_soft_lambert_windowed);
