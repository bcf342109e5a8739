//! A colour in sRGB codes of eight bits, dithered.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::encode_srgb_dithered;
use luminaire_effects::{Color, Place};

luminaire_effects::program!(|(color, Place { x, y }): (Color, Place)| {
    color.map(|channel| encode_srgb_dithered(channel, x, y))
});
