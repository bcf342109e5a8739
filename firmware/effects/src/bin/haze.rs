//! The air light of a view ray through the beam of a spotlight in haze. It is f32 in every format.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::haze);
