//! Light scaled to full scale with its hue, in three channels.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::keep_hue;
use luminaire_effects::{Format, Light};

luminaire_effects::program!(|light: Light| keep_hue::<Format>(light));
