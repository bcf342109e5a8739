//! A surface with Lyon's form of Phong's highlight by three squarings, of a shininess of 32, under a directional light.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{
    Surface,
    constants::{DIRECTIONAL, LYON},
};

luminaire_effects::program!(|surface: Surface| LYON.reflect(&surface, &DIRECTIONAL));
