//! Conversion of linear light to the bytes of a display.

use crate::buffer::{LANES, Radiance};
use luminaire::{
    Rgb, Scalar,
    display::{
        Gray1, Gray2, Gray4, Gray8, Palette, Pixel, Rgb332, Rgb444, Rgb555, Rgb565, Rgb666, Rgb888,
        compress_keep_hue, encode_srgb, encode_srgb_dithered_each, encode_srgb_each,
    },
};

/// Bytes per pixel: red, green, blue, alpha.
pub(crate) const CHANNELS: usize = 4;

/// The display of a picture: three independent choices.
///
/// ```
/// use luminaire_render::{Display, Output};
/// let display = Display { keeps_hue: true, ..Output::Gray4.dithered() };
/// assert_eq!((display.output, display.is_dithered), (Output::Gray4, true));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Display {
    /// The pixels of the display.
    pub output: Output,
    /// Whether ordered dither hides the steps between two codes.
    pub is_dithered: bool,
    /// Whether overexposed light keeps its hue: see [`compress_keep_hue`]. Otherwise each channel is
    /// clipped.
    pub keeps_hue: bool,
}

/// Declares the outputs: each row has a [`Pixel`] of the kernel, its name and its title.
macro_rules! outputs {
    ($($(#[$doc:meta])* $pixel:ident = $name:literal, $title:literal;)*) => {
        /// The pixels of a display, expanded to eight bits per channel for preview.
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
        #[non_exhaustive]
        pub enum Output {
            $($(#[$doc])* $pixel,)*
            /// Electronic paper with seven colours: see [`ACEP`].
            Acep,
        }

        impl Output {
            /// All outputs, fewest bits first.
            pub const ALL: &[Self] = &[$(Self::$pixel,)* Self::Acep];

            /// Returns the name for addresses.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$pixel => $name,)*
                    Self::Acep => "acep",
                }
            }

            /// Returns the title.
            pub const fn title(self) -> &'static str {
                match self {
                    $(Self::$pixel => $title,)*
                    Self::Acep => "e-paper, 7 colours",
                }
            }
        }

        impl Encoder {
            /// Writes the codes of a block with the pixels of any output.
            fn encode_pixels<S: Scalar>(&self, linear: &Linear<S>, place: (u32, u32), pixels: &mut [u8]) {
                match self.display.output {
                    $(Output::$pixel => self.encode_each::<S, $pixel>(linear, place, pixels),)*
                    Output::Acep => {
                        let place = |lane| (place.0 + lane as u32, place.1);
                        let dither = |lane| self.display.is_dithered.then(|| place(lane));
                        write(pixels, |lane| self.acep(at(linear, lane), dither(lane)));
                    }
                }
            }

            /// Returns the codes of a linear colour, without dither.
            fn nearest(&self, color: Rgb<f32>) -> Rgb<u8> {
                match self.display.output {
                    $(Output::$pixel => $pixel::nearest(color).to_codes(),)*
                    Output::Acep => self.acep(color, None),
                }
            }
        }
    };
}

outputs! {
    /// Black and white.
    Gray1 = "gray1", "black and white";
    /// Four greys.
    Gray2 = "gray2", "4 greys";
    /// 16 greys.
    Gray4 = "gray4", "16 greys";
    /// 256 greys.
    Gray8 = "gray8", "256 greys";
    /// Three bits of red and green, two of blue.
    Rgb332 = "rgb332", "RGB332, 8 bits";
    /// Four bits per channel.
    Rgb444 = "rgb444", "RGB444, 12 bits";
    /// Five bits per channel.
    Rgb555 = "rgb555", "RGB555, 15 bits";
    /// Five bits of red and blue, six of green.
    Rgb565 = "rgb565", "RGB565, 16 bits";
    /// Six bits per channel.
    Rgb666 = "rgb666", "RGB666, 18 bits";
    /// Eight bits per channel.
    #[default]
    Rgb888 = "rgb888", "RGB888, 24 bits";
}

/// The colours of a seven-colour panel of E Ink's ACeP in sRGB, as they look: black, white, green,
/// blue, red, yellow, orange. Source: the palette "saturated" of Pimoroni's library for the panels,
/// `inky_uc8159.py`.
pub const ACEP: [Rgb<u8>; 7] = [
    Rgb::new(57, 48, 57),
    Rgb::new(255, 255, 255),
    Rgb::new(58, 91, 70),
    Rgb::new(61, 59, 94),
    Rgb::new(156, 72, 75),
    Rgb::new(208, 190, 71),
    Rgb::new(177, 106, 73),
];

impl Output {
    /// Returns the display with this output, without dither, that clips overexposed light.
    pub const fn nearest(self) -> Display {
        Display { output: self, is_dithered: false, keeps_hue: false }
    }

    /// Returns the same display as [`nearest`](Self::nearest), with dither.
    pub const fn dithered(self) -> Display {
        Display { is_dithered: true, ..self.nearest() }
    }

    /// Returns whether the output has all codes of eight bits.
    pub fn has_all_codes(self) -> bool {
        matches!(self, Self::Gray8 | Self::Rgb888)
    }
}

/// A display with the table of its palette.
#[derive(Clone, Debug)]
pub struct Encoder {
    pub(crate) display: Display,
    /// The palette; `None` for the pixels of an output without one.
    palette: Option<Palette<'static>>,
}

impl Encoder {
    pub(crate) fn new(display: Display) -> Self {
        let palette = if display.output == Output::Acep { Palette::new(&ACEP).ok() } else { None };
        Self { display, palette }
    }

    /// Returns the codes of a linear colour, without dither.
    pub(crate) fn code(&self, color: Rgb<f32>) -> Rgb<u8> {
        let color = if self.display.keeps_hue { compress_keep_hue(color) } else { color };
        self.nearest(color)
    }

    /// Writes the codes of a block whose first pixel is at `(x, y)`, until `pixels` is full.
    #[inline(always)]
    pub(crate) fn encode<S: Scalar>(&self, radiance: &Radiance<S>, (x, y): (u32, u32), pixels: &mut [u8]) {
        let Display { output, is_dithered, keeps_hue } = self.display;
        let linear = if keeps_hue && is_overexposed::<S>(radiance) {
            keep_hue::<S>(radiance)
        } else {
            radiance.map(|channel| channel.map(S::clip))
        };
        if output != Output::Rgb888 {
            return self.encode_pixels(&linear, (x, y), pixels);
        }
        // Encodes one channel of the whole block at a time, so that compilers use vector
        // instructions.
        let codes = if is_dithered {
            linear.map(|channel| encode_srgb_dithered_each(&channel, x, y))
        } else {
            linear.map(|channel| encode_srgb_each(&channel))
        };
        write(pixels, |lane| at(&codes, lane));
    }

    // Two loops without a branch per pixel: with one for both, RGB565 with dither took 1.3 times as long.
    #[inline(never)]
    fn encode_each<S: Scalar, P: Pixel>(&self, linear: &Linear<S>, (x, y): (u32, u32), pixels: &mut [u8]) {
        if self.display.is_dithered {
            write(pixels, |lane| P::dithered(at(linear, lane), x + lane as u32, y).to_codes());
        } else {
            write(pixels, |lane| P::nearest(at(linear, lane)).to_codes());
        }
    }

    /// Returns the colour of the palette for a linear colour, with dither if it gets a place.
    fn acep<S: Scalar>(&self, color: Rgb<S>, place: Option<(u32, u32)>) -> Rgb<u8> {
        let Some(palette) = &self.palette else { return color.map(encode_srgb) };
        palette.color(match place {
            Some((x, y)) => palette.dithered(color, x, y),
            None => palette.nearest(color),
        })
    }
}

/// Light within full scale at the pixels of a block.
type Linear<S> = Rgb<[S; LANES]>;

fn at<T: Copy>(channels: &Rgb<[T; LANES]>, lane: usize) -> Rgb<T> {
    Rgb::new(channels.red[lane], channels.green[lane], channels.blue[lane])
}

/// Returns whether any channel exceeds full scale. In most blocks none does.
fn is_overexposed<S: Scalar>(Rgb { red, green, blue }: &Radiance<S>) -> bool {
    let full = S::ONE.light(S::gain(1.0));
    // The fold has no early exit, so that compilers vectorise it.
    let channels = red.iter().zip(green).zip(blue);
    channels.fold(false, |is_over, ((red, green), blue)| {
        is_over | (*red > full) | (*green > full) | (*blue > full)
    })
}

fn keep_hue<S: Scalar>(radiance: &Radiance<S>) -> Linear<S> {
    let mut kept = Rgb::default().map(|()| [S::ZERO; LANES]);
    for lane in 0..LANES {
        let Rgb { red, green, blue } = compress_keep_hue(at(radiance, lane));
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
