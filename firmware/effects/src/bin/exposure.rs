//! Light after an exposure, in three channels.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire_effects::{Light, constants::EXPOSURE};

luminaire_effects::program!(|light: Light| EXPOSURE.expose(light));
