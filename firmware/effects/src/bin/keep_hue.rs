//! Light scaled to full scale with its hue, in three channels.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::keep_hue);
