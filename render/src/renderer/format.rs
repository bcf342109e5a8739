//! The number formats of the renderer.

use crate::{
    buffer::{LANES, Radiance},
    light::{Setting, Workspace, air, block::Block, prepared::Prepared},
    renderer::display::Encoder,
};
use luminaire::{Fx16, Fx32, Rgb, Scalar, number::Length};

/// A number format of the renderer: `f32`, [`Fx32`] or [`Fx16`].
pub trait Format: Scalar + Loops {
    /// The result of [`stated_error`].
    const STATED_ERROR: u8;
}

/// The loops over pixels of a format, compiled once in this crate instead of in each crate that uses
/// the renderer.
pub trait Loops: Scalar {
    /// Lights the pixels of a block. Returns the number of lights that were evaluated with a
    /// highlight.
    fn light(
        setting: &Setting<'_, Self>,
        block: &Block<Self>,
        fixtures: &[&Prepared<Self>],
        work: &mut Workspace<Self>,
        radiance: &mut Radiance<Self>,
    ) -> usize;

    /// Adds light from the air in front of the pixels of a block.
    fn add_air(radiance: &mut Radiance<Self>, light: &Rgb<[f32; LANES]>);

    /// Writes the codes of a block whose first pixel is at `place`, until `pixels` is full.
    fn encode(encoder: &Encoder, radiance: &Radiance<Self>, place: (u32, u32), pixels: &mut [u8]);

    /// The bits of a depth.
    fn depth_to_bits(depth: Self::Length) -> u32;

    /// The depth of these bits.
    fn depth_from_bits(bits: u32) -> Self::Length;
}

impl Format for f32 {
    const STATED_ERROR: u8 = 0;
}

impl Format for Fx32 {
    const STATED_ERROR: u8 = 2;
}

impl Format for Fx16 {
    const STATED_ERROR: u8 = 2;
}

macro_rules! loops {
    ($($format:ty, $to_bits:expr, $from_bits:expr;)*) => {$(
        impl Loops for $format {
            fn light(
                setting: &Setting<'_, Self>,
                block: &Block<Self>,
                fixtures: &[&Prepared<Self>],
                work: &mut Workspace<Self>,
                radiance: &mut Radiance<Self>,
            ) -> usize {
                setting.light(block, fixtures, work, radiance)
            }

            fn add_air(radiance: &mut Radiance<Self>, light: &Rgb<[f32; LANES]>) {
                air::add::<Self>(radiance, light);
            }

            fn encode(encoder: &Encoder, radiance: &Radiance<Self>, place: (u32, u32), pixels: &mut [u8]) {
                encoder.encode::<Self>(radiance, place, pixels);
            }

            fn depth_to_bits(depth: Self::Length) -> u32 {
                $to_bits(depth)
            }

            fn depth_from_bits(bits: u32) -> Self::Length {
                $from_bits(bits)
            }
        }
    )*};
}

loops! {
    f32, f32::to_bits, f32::from_bits;
    Fx32, |depth: Length| depth.to_bits() as u32, |bits| Length::from_bits(bits as i32);
    Fx16, |depth: Length| depth.to_bits() as u32, |bits| Length::from_bits(bits as i32);
}

/// Returns the largest difference of a channel between a picture in this format and a picture in
/// `f32`.
///
/// The difference is in sRGB codes of 0 to 255. The difference was measured on the
/// [stage](crate::scenes::stage) from several cameras: under the stage's own lights, and under hard
/// beams of 4 degrees that are four times as bright. Under the stage's own lights the difference is
/// 1 code in both fixed-point formats: in about one of 75 channels with 16 bits, and in one of 5,000 channels
/// with 32 bits. In each of the [examples](crate::scenes::Example) the difference is at most 1 code but for one of
/// 1,000 pixels, beside the edges of shadows.
pub const fn stated_error<S: Format>() -> u8 {
    S::STATED_ERROR
}
