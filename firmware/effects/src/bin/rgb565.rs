//! A colour as a pixel of 16 bits.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::Rgb565;
use luminaire_effects::Color;

luminaire_effects::program!(|color: Color| Rgb565::from_linear(color));
