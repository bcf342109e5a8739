//! A colour as a pixel of 16 bits.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::rgb565);
