//! A colour as a pixel of 16 bits, dithered.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::Rgb565;
use luminaire_effects::{Color, Place};

luminaire_effects::program!(|(color, Place { x, y }): (Color, Place)| {
    Rgb565::from_linear_dithered(color, x, y)
});
