//! The effects, each a function of one input: what a program's bytes are counted of, and its instructions.

mod display;
mod spot;
mod surface;

pub use display::{clip, dither, exposure, keep_hue, rgb565, rgb565_dithered, srgb};
pub use spot::{
    haze, spot_blend_lambert, spot_cubic_lambert, spot_cut_off_lambert, spot_hard_lambert,
    spot_linear_lambert, spot_power_lambert, spot_rim_lambert, spot_smooth_lambert, spot_soft,
    spot_soft_lambert, spot_soft_lambert_delimiter, spot_soft_lambert_gobo, spot_soft_lambert_hard_range,
    spot_soft_lambert_hotspot, spot_soft_lambert_inverse_square, spot_soft_lambert_polynomial,
    spot_soft_lambert_shadow, spot_soft_lambert_smooth_range, spot_soft_lambert_squared_window,
    spot_soft_lambert_windowed, spot_table_lambert,
};
pub use surface::{ambient, blinn_phong, directional, dual_cone, lyon, matte, phong, point};
