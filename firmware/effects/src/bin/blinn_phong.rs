//! The surface with a highlight by Blinn and Phong, of a shininess of 32.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{
    Surface,
    constants::{BLINN_PHONG, DIRECTIONAL},
};

luminaire_effects::program!(|surface: Surface| BLINN_PHONG.reflect(&surface, &DIRECTIONAL));
