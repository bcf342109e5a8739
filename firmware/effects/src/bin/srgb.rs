//! A colour in sRGB codes of eight bits.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::encode_srgb;
use luminaire_effects::Color;

luminaire_effects::program!(|color: Color| color.map(encode_srgb));
