//! A surface with Phong's highlight, of a shininess of 32, under a directional light.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{
    Surface,
    constants::{DIRECTIONAL, PHONG},
};

luminaire_effects::program!(|surface: Surface| PHONG.reflect(&surface, &DIRECTIONAL));
