//! Conversion of linear light to display codes, without a power function.
//!
//! Light in this crate is linear, and an output is not always: choose the one whose curve is the
//! display's.
//!
//! | for | output | curve |
//! |---|---|---|
//! | an LED by pulse width, 1 to 16 bits | [`Pwm::duty`]; without steps at low light [`TemporalDither`] | linear |
//! | a strip of addressable LEDs: WS2812, SK6812 RGBW, APA102, HD108 | [`LedStrip`], the bytes of a [`LedChip`] with a limit of the current | linear |
//! | an LED driver or a panel that itself applies a gamma to eight bits | [`Curve::encode`] of [`Gamma22`] or [`Gamma28`] | power |
//! | a matrix of LEDs of eight bits without a gamma | [`Curve::encode_dithered`] of [`Linear`] | linear |
//! | a colour display | [`Rgb332`], [`Rgb444`], [`Rgb555`], [`Rgb565`], [`Rgb666`], [`Rgb888`], each a [`Pixel`] | sRGB |
//! | a monochrome or grey display | [`Gray1`], [`Gray2`], [`Gray4`], [`Gray8`], each a [`Pixel`] | sRGB |
//! | electronic paper of a few colours, an indexed display | [`Palette`] | sRGB |
//! | a canvas, a PNG, a texture | [`encode_srgb`], [`encode_srgb_dithered`] | sRGB |
//!
//! [`pack`] writes a row of pixels in the bytes of a display. The same light has different codes:
//!
//! ```
//! use luminaire::{Fx16, Rgb, display::{Gray4, Layout, Pixel, Pwm8, encode_srgb, pack}};
//! let light = Fx16::from_f32(0.2);
//! assert_eq!(encode_srgb(light), 124); // what an sRGB display shows as a fifth of its light
//! assert_eq!(Pwm8::duty(light), 51); // a fifth of the time: an LED by the code 124 is too bright
//!
//! let row = [0, 1, 2, 3].map(|x| Gray4::dithered(Rgb::new(light, light, light), x, 0));
//! let mut bytes = [0; 2];
//! assert_eq!(pack(&row, Layout::MsbFirst, &mut bytes), 4);
//! assert_eq!(bytes, [0x87, 0x87]);
//! ```

mod curve;
mod decode;
mod dither;
mod encode;
mod exposure;
#[cfg(feature = "fixed")]
mod fast;
mod fit;
mod gray;
mod leds;
mod levels;
mod pack;
mod palette;
mod pixel;
mod pwm;
mod ramp;
mod rgb565;
mod srgb;

#[cfg(all(feature = "arithmetic", feature = "fixed"))]
pub(crate) use self::{curve::Encoding, dither::code_lights, srgb::code_thresholds};
pub use self::{
    curve::{Gamma22, Gamma28, Linear, Srgb},
    decode::decode_srgb,
    dither::{encode_srgb_dithered, encode_srgb_dithered_each, threshold},
    encode::Curve,
    exposure::{CompiledExposure, Exposure},
    fit::{clip, compress_keep_hue},
    gray::{Gray1, Gray2, Gray4, Gray8},
    leds::{Apa102, CurrentDither, Hd108, LedChip, LedFrame, LedLoad, LedOrder, LedStrip, Rgbw},
    pack::{Layout, pack},
    palette::Palette,
    pixel::{Pixel, Rgb332, Rgb444, Rgb555, Rgb565, Rgb666, Rgb888},
    pwm::{Pwm, Pwm8, TemporalDither},
    ramp::{Ramp, Rgb565Ramp},
    srgb::{encode_srgb, encode_srgb_each},
};
pub(crate) use self::{
    decode::decode,
    levels::{offsets, packed, shown},
};
