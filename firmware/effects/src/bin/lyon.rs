//! A surface with Lyon's form of Phong's highlight by three squarings, of a shininess of 32, under a directional light.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::lyon);
