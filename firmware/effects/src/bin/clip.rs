//! Light clipped to full scale, in three channels.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::clip;
use luminaire_effects::{Format, Light};

luminaire_effects::program!(|light: Light| clip::<Format>(light));
