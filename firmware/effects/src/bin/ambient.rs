//! Ambient light on a matt surface.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::constants::{AMBIENT, MATTE};

luminaire_effects::program!(|(): ()| MATTE.glow(AMBIENT));
