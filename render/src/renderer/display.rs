//! Conversion of linear light to the bytes of a display.

use crate::buffer::{LANES, Radiance};
use luminaire::{
    Rgb,
    display::{Rgb565, compress_keep_hue, encode_srgb, encode_srgb_dithered_each, encode_srgb_each},
};

/// Bytes per pixel: red, green, blue, alpha.
pub(crate) const CHANNELS: usize = 4;

/// The display format of a picture.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
#[non_exhaustive]
pub enum Display {
    /// 8 bits per channel.
    #[default]
    Rgb888,
    /// 8 bits per channel, dithered against banding.
    Rgb888Dithered,
    /// 8 bits per channel. Overexposed light keeps its hue: see [`compress_keep_hue`].
    Rgb888KeepHue,
    /// 8 bits per channel, dithered against banding. Overexposed light keeps its hue.
    Rgb888KeepHueDithered,
    /// RGB565, expanded to 8 bits per channel for preview.
    Rgb565,
    /// RGB565, dithered against banding and expanded to 8 bits per channel.
    Rgb565Dithered,
}

impl Display {
    /// Returns whether the picture is dithered.
    pub fn is_dithered(self) -> bool {
        matches!(self, Self::Rgb888Dithered | Self::Rgb888KeepHueDithered | Self::Rgb565Dithered)
    }

    /// Returns whether overexposed light keeps its hue. Otherwise each channel is clipped.
    pub fn keeps_hue(self) -> bool {
        matches!(self, Self::Rgb888KeepHue | Self::Rgb888KeepHueDithered)
    }

    /// Returns the code of a linear colour, without dither.
    pub(crate) fn code(self, color: Rgb<f32>) -> Rgb<u8> {
        match self {
            Self::Rgb888 | Self::Rgb888Dithered => color.map(encode_srgb),
            Self::Rgb888KeepHue | Self::Rgb888KeepHueDithered => {
                compress_keep_hue::<f32>(color).map(encode_srgb)
            }
            Self::Rgb565 | Self::Rgb565Dithered => Rgb565::from_linear(color).to_codes(),
        }
    }

    /// Writes the codes of a block whose first pixel is at `(x, y)`, until `pixels` is full.
    pub(crate) fn encode(self, radiance: &Radiance, (x, y): (u32, u32), pixels: &mut [u8]) {
        let kept = (self.keeps_hue() && is_overexposed(radiance)).then(|| keep_hue(radiance));
        let radiance = kept.as_ref().unwrap_or(radiance);
        match self {
            // Encodes one channel of the whole block at a time, so that compilers use vector
            // instructions.
            Self::Rgb888 | Self::Rgb888KeepHue => {
                let codes = radiance.map(|channel| encode_srgb_each(&channel));
                write(pixels, |lane| Rgb::new(codes.red[lane], codes.green[lane], codes.blue[lane]));
            }
            Self::Rgb888Dithered | Self::Rgb888KeepHueDithered => {
                let codes = radiance.map(|channel| encode_srgb_dithered_each(&channel, x, y));
                write(pixels, |lane| Rgb::new(codes.red[lane], codes.green[lane], codes.blue[lane]));
            }
            Self::Rgb565 => {
                write(pixels, |lane| Rgb565::from_linear(linear(radiance, lane)).to_codes());
            }
            Self::Rgb565Dithered => write(pixels, |lane| {
                Rgb565::from_linear_dithered(linear(radiance, lane), x + lane as u32, y).to_codes()
            }),
        }
    }
}

fn linear(radiance: &Radiance, lane: usize) -> Rgb<f32> {
    Rgb::new(radiance.red[lane], radiance.green[lane], radiance.blue[lane])
}

/// Returns whether any channel exceeds full scale. In most blocks none does.
fn is_overexposed(Rgb { red, green, blue }: &Radiance) -> bool {
    // The fold has no early exit, so that compilers vectorise it.
    let channels = red.iter().zip(green).zip(blue);
    channels
        .fold(false, |is_over, ((red, green), blue)| is_over | (*red > 1.0) | (*green > 1.0) | (*blue > 1.0))
}

fn keep_hue(radiance: &Radiance) -> Radiance {
    let mut kept = *radiance;
    for lane in 0..LANES {
        let Rgb { red, green, blue } = compress_keep_hue::<f32>(linear(radiance, lane));
        (kept.red[lane], kept.green[lane], kept.blue[lane]) = (red, green, blue);
    }
    kept
}

/// Writes the code of each pixel. `code` returns the code for the pixel's index in the block.
#[inline(always)]
fn write(pixels: &mut [u8], code: impl Fn(usize) -> Rgb<u8>) {
    for (lane, pixel) in pixels.chunks_exact_mut(CHANNELS).enumerate().take(LANES) {
        let Rgb { red, green, blue } = code(lane);
        pixel.copy_from_slice(&[red, green, blue, u8::MAX]);
    }
}
