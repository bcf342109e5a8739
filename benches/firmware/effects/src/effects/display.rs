//! From light to the codes of a display, in three channels.

use luminaire::{Rgb, display::Rgb565};

use crate::constants::{EXPOSURE, RAMP};
use crate::format::{Color, Format, Light};
use crate::input::Place;

effects! { each;
    /// Stops: a picture that is brighter or darker than its light.
    "exposure", light, [];
    fn exposure(light: Light) -> Light { EXPOSURE.expose(light) }

    /// What is over full scale becomes full scale.
    "clip", light, [];
    fn clip(light: Light) -> Color { luminaire::display::clip::<Format>(light) }

    /// What is over full scale is scaled to it, and its hue stays.
    "keep hue", light, [] over "clip";
    fn keep_hue(light: Light) -> Color { luminaire::display::compress_keep_hue::<Format>(light) }

    /// Codes of eight bits for a display.
    "sRGB", color, [];
    fn srgb(color: Color) -> Rgb<u8> { color.map(luminaire::display::encode_srgb) }

    /// Ordered dither against banding: a picture with slow gradients needs it.
    "sRGB, dithered", pixel, [Dither] over "srgb";
    fn dither((color, Place { x, y }): (Color, Place)) -> Rgb<u8> {
        color.map(|channel| luminaire::display::encode_srgb_dithered(channel, x, y))
    }

    /// Pixels of 16 bits for a small display.
    "RGB565", color, [];
    fn rgb565(color: Color) -> Rgb565 { Rgb565::from_linear(color) }

    /// The same dither, which so few codes need more.
    "RGB565, dithered", pixel, [Dither] over "rgb565";
    fn rgb565_dithered((color, Place { x, y }): (Color, Place)) -> Rgb565 { Rgb565::from_linear_dithered(color, x, y) }

    /// The same pixels. In fixed point the search for the codes starts from a table of 512 bytes.
    "RGB565, dithered fast", pixel, [Dither] over "rgb565";
    fn rgb565_dithered_fast((color, Place { x, y }): (Color, Place)) -> Rgb565 { Rgb565::from_linear_dithered_fast(color, x, y) }

    /// The pixel of a surface of one colour by its irradiance: the colours, the sum, the clip and the
    /// dither in a table of 2,560 bytes.
    "RGB565, dithered, from a ramp", lit, [Dither];
    fn rgb565_ramp((light, Place { x, y }): (Light, Place)) -> Rgb565 { RAMP.pixel::<Format>(light.red, x, y) }
}
