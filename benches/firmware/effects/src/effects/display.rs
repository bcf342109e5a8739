//! From light to the codes of a display, in three channels.

use core::hint::black_box;

use luminaire::{
    Rgb,
    display::{
        Curve, Gamma22, Gamma28, Gray1, Gray2, Gray4, Gray8, Pixel, Pwm, Pwm8, Rgb332, Rgb444, Rgb555,
        Rgb565, Rgb666,
    },
};

use crate::constants::{EXPOSURE, PALETTE, RAMP, STRIP};
use crate::format::{Color, Format, Light};
use crate::input::Place;

effects! { each;
    /// The light that a texture of 16 bits reflects.
    "texel", lit, [];
    fn texel((light, Place { x, y }): (Light, Place)) -> Light {
        let texel = Rgb565((y << 8 | x) as u16);
        light.filtered(texel.to_codes().map(luminaire::display::decode_srgb::<Format>))
    }

    /// Stops: a picture that is brighter or darker than its light.
    "exposure", light, [];
    fn exposure(light: Light) -> Light { EXPOSURE.expose(light) }

    /// What is over full scale becomes full scale.
    "clip", light, [];
    fn clip(light: Light) -> Color { luminaire::display::clip(light) }

    /// What is over full scale is scaled to it, and its hue stays.
    "keep hue", light, [] over "clip";
    fn keep_hue(light: Light) -> Color { luminaire::display::compress_keep_hue(light) }

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

    /// The same pixels. In fixed point the search for the codes starts from a table.
    "RGB565, dithered fast", pixel, [Dither] over "rgb565";
    fn rgb565_dithered_fast((color, Place { x, y }): (Color, Place)) -> Rgb565 { Rgb565::from_linear_dithered_fast(color, x, y) }

    /// Black and white: electronic paper, small monochrome displays.
    "1-bit grey, dithered", pixel, [Dither];
    fn gray1((color, Place { x, y }): (Color, Place)) -> Gray1 { Gray1::dithered(color, x, y) }

    /// Four greys.
    "2-bit grey, dithered", pixel, [Dither];
    fn gray2((color, Place { x, y }): (Color, Place)) -> Gray2 { Gray2::dithered(color, x, y) }

    /// 16 greys.
    "4-bit grey, dithered", pixel, [Dither];
    fn gray4((color, Place { x, y }): (Color, Place)) -> Gray4 { Gray4::dithered(color, x, y) }

    /// 256 greys.
    "8-bit grey", color, [];
    fn gray8(color: Color) -> Gray8 { Gray8::nearest(color) }

    /// Pixels of eight bits.
    "RGB332, dithered", pixel, [Dither];
    fn rgb332((color, Place { x, y }): (Color, Place)) -> Rgb332 { Rgb332::dithered(color, x, y) }

    /// Pixels of twelve bits, the fastest of many SPI displays.
    "RGB444, dithered", pixel, [Dither];
    fn rgb444((color, Place { x, y }): (Color, Place)) -> Rgb444 { Rgb444::dithered(color, x, y) }

    /// Pixels of 15 bits.
    "RGB555, dithered", pixel, [Dither];
    fn rgb555((color, Place { x, y }): (Color, Place)) -> Rgb555 { Rgb555::dithered(color, x, y) }

    /// Pixels of 18 bits.
    "RGB666, dithered", pixel, [Dither];
    fn rgb666((color, Place { x, y }): (Color, Place)) -> Rgb666 { Rgb666::dithered(color, x, y) }

    /// The nearest of seven colours of electronic paper, dithered, from a table of 4,096 bytes.
    "palette, dithered", pixel, [Dither];
    fn palette((color, Place { x, y }): (Color, Place)) -> u8 { PALETTE.dithered(color, x, y) }

    /// Duties of eight bits for an LED.
    "LED", color, [];
    fn led(color: Color) -> Rgb<u16> { color.map(Pwm8::duty) }

    /// Duties of 16 bits for an LED.
    "LED of 16 bits", color, [];
    fn led16(color: Color) -> Rgb<u16> { color.map(Pwm::<16>::duty) }

    /// Duties of eight bits that carry their rounding to the next frame, dimmed by the limit of a strip.
    "LED, dithered in time", color, [Dither] over "led";
    fn led_dithered(color: Color) -> [u8; 3] {
        let mut bytes = [0; 3];
        let mut dithers = black_box([Rgb::default()]);
        STRIP.write(&[color], &mut dithers, &mut bytes);
        bytes
    }

    /// Codes of eight bits for a driver that applies a gamma of 2.2 to them.
    "gamma 2.2", color, [];
    fn gamma22(color: Color) -> Rgb<u8> { color.map(Gamma22::encode) }

    /// Codes of eight bits for a driver that applies a gamma of 2.8 to them.
    "gamma 2.8", color, [];
    fn gamma28(color: Color) -> Rgb<u8> { color.map(Gamma28::encode) }

    /// The pixel of a surface of one colour by its irradiance: the colours, the sum, the clip and the
    /// dither in a table of 2,560 bytes.
    "RGB565, dithered, from a ramp", lit, [Dither];
    fn rgb565_ramp((light, Place { x, y }): (Light, Place)) -> Rgb565 { RAMP.pixel::<Format>(light.red, x, y) }
}
