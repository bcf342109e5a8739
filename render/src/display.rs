//! From linear light to the bytes of a display.

use crate::{gbuffer::LANES, lighting::Radiance};
use luminaire::encode_srgb;

/// Bytes to a pixel: red, green, blue, alpha.
pub(crate) const CHANNELS: usize = 4;

/// Writes the sRGB codes of a block, as many as there is room for.
pub(crate) fn encode(radiance: &Radiance, pixels: &mut [u8]) {
    let codes = radiance.map(|channel| channel.map(encode_srgb));
    for (lane, pixel) in pixels.chunks_exact_mut(CHANNELS).enumerate().take(LANES) {
        pixel.copy_from_slice(&[codes.red[lane], codes.green[lane], codes.blue[lane], u8::MAX]);
    }
}
