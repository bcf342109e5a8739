//! Ambient light on a matt surface, beside the light of lamps.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::ambient);
