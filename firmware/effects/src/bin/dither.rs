//! A colour in sRGB codes of eight bits, dithered.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::dither);
