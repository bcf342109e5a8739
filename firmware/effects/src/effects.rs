//! The effects, each a function of one input: what a program's bytes are counted of, and its instructions.

mod display;
mod spot;
mod surface;

pub use display::{clip, dither, exposure, keep_hue, rgb565, rgb565_dithered, srgb};
pub use spot::{
    haze, spot_soft, spot_soft_lambert_delimiter, spot_soft_lambert_gobo, spot_soft_lambert_hotspot,
    spot_soft_lambert_shadow,
};
pub use surface::{ambient, directional, matte, point};
