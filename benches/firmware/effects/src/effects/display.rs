//! From light to the codes of a display, in three channels.

use luminaire::{Rgb, display::Rgb565};

use crate::constants::{EXPOSURE, RAMP};
use crate::{Color, Format, Light, Place};

list! {
    light: exposure clip keep_hue;
    lit: rgb565_ramp;
    color: srgb rgb565;
    pixel: dither rgb565_dithered rgb565_dithered_fast;
}

/// Light after an exposure.
#[inline(always)]
pub fn exposure(light: Light) -> Light {
    EXPOSURE.expose(light)
}

/// Light clipped to full scale.
#[inline(always)]
pub fn clip(light: Light) -> Color {
    luminaire::display::clip::<Format>(light)
}

/// Light scaled to full scale, with its hue kept.
#[inline(always)]
pub fn keep_hue(light: Light) -> Color {
    luminaire::display::compress_keep_hue::<Format>(light)
}

/// A colour in sRGB codes of eight bits.
#[inline(always)]
pub fn srgb(color: Color) -> Rgb<u8> {
    color.map(luminaire::display::encode_srgb)
}

/// A colour in sRGB codes of eight bits, dithered.
#[inline(always)]
pub fn dither((color, Place { x, y }): (Color, Place)) -> Rgb<u8> {
    color.map(|channel| luminaire::display::encode_srgb_dithered(channel, x, y))
}

/// A colour as a pixel of 16 bits.
#[inline(always)]
pub fn rgb565(color: Color) -> Rgb565 {
    Rgb565::from_linear(color)
}

/// A colour as a pixel of 16 bits, dithered.
#[inline(always)]
pub fn rgb565_dithered((color, Place { x, y }): (Color, Place)) -> Rgb565 {
    Rgb565::from_linear_dithered(color, x, y)
}

/// The same pixel with fewer instructions and a table of 512 bytes.
#[inline(always)]
pub fn rgb565_dithered_fast((color, Place { x, y }): (Color, Place)) -> Rgb565 {
    Rgb565::from_linear_dithered_fast(color, x, y)
}

/// The pixel of a surface of one colour by the irradiance, from a table.
#[inline(always)]
pub fn rgb565_ramp((light, Place { x, y }): (Light, Place)) -> Rgb565 {
    RAMP.pixel::<Format>(light.red, x, y)
}
