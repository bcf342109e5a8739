//! A matt surface under a directional light, in colours.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{
    Surface,
    constants::{DIRECTIONAL, MATTE},
};

luminaire_effects::program!(|surface: Surface| MATTE.reflect(&surface, &DIRECTIONAL));
