//! A surface with Phong's highlight, of a shininess of 32, under a directional light.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::phong);
