//! A surface with Blinn's form of Phong's highlight, of a shininess of 32, under a directional light.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{
    Surface,
    constants::{BLINN_PHONG, DIRECTIONAL},
};

luminaire_effects::program!(|surface: Surface| BLINN_PHONG.reflect(&surface, &DIRECTIONAL));
