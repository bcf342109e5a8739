//! Nothing: what a program takes that has no effect.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(|(): ()| ());
