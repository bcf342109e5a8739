//! Conversion of linear light to display codes, without a power function.

mod dither;
mod exposure;
mod fit;
mod ramp;
mod rgb565;
mod srgb;

pub use self::{
    dither::{encode_srgb_dithered, encode_srgb_dithered_each},
    exposure::{CompiledExposure, Exposure},
    fit::{clip, compress_keep_hue},
    ramp::Rgb565Ramp,
    rgb565::Rgb565,
    srgb::{decode_srgb, encode_srgb, encode_srgb_each},
};
