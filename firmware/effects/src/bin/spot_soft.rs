//! The falloff of a spotlight with a soft edge alone.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::spot_soft);
