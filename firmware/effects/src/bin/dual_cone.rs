//! A surface with the dual-cone highlight, of a shininess of 32, under a directional light.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{
    Surface,
    constants::{DIRECTIONAL, DUAL_CONE},
};

luminaire_effects::program!(|surface: Surface| DUAL_CONE.reflect(&surface, &DIRECTIONAL));
