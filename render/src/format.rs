//! What the renderer knows of a number format.

use crate::{
    block::Block,
    lanes::Radiance,
    lighting::{Setting, Workspace},
    prepared::Prepared,
};
use luminaire::{Fx16, Fx32, Scalar};

/// A number format that a picture can be lit in: `f32`, [`Fx32`] and [`Fx16`].
pub trait Format: Scalar + Loops {
    /// See [`stated_error`].
    const STATED_ERROR: u8;
}

/// The loops of a format. They are compiled with this crate, once, and not with each that uses it.
pub trait Loops: Scalar {
    /// Lights the pixels of a block. Returns how many of the lights were evaluated with a highlight.
    fn light(
        setting: &Setting<'_, Self>,
        block: &Block<Self>,
        fixtures: &[&Prepared<Self>],
        work: &mut Workspace<Self>,
        radiance: &mut Radiance,
    ) -> usize;
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
    ($($format:ty)*) => {$(
        impl Loops for $format {
            fn light(
                setting: &Setting<'_, Self>,
                block: &Block<Self>,
                fixtures: &[&Prepared<Self>],
                work: &mut Workspace<Self>,
                radiance: &mut Radiance,
            ) -> usize {
                setting.light(block, fixtures, work, radiance)
            }
        }
    )*};
}

loops!(f32 Fx32 Fx16);

/// The largest difference of a channel between a picture lit in this format and one in `f32`, in sRGB codes
/// of 0 to 255.
///
/// Measured on the [stage](crate::stage) from several cameras: under its own lights, and under hard beams of
/// 4 degrees four times as bright. Under its own lights it is 1 in either fixed format: in 16 bits of about
/// one channel in 200, in 32 bits of one in 5,000.
pub const fn stated_error<S: Format>() -> u8 {
    S::STATED_ERROR
}
