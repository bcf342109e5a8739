//! Dithered pixels of surfaces of one colour, from a table.

use core::array;

use super::{
    Rgb565,
    curve::Srgb,
    dither::{self, CodeLight},
};
use crate::{
    color::{Rgb, checked_color},
    error::Error,
    number::{Scalar, float::clamp},
};

/// A surface of one colour under lights of one colour: its dithered RGB565 pixels by the irradiance.
///
/// Where neither the surface nor the light changes its colour, a pixel depends on one number. A
/// table then replaces the two colours, the sum, the clip, the encoding and the dither;
/// `docs/EFFECTS.md` has the instructions of both (`cargo xtask measure`). A table has 2,560 bytes; a build
/// script can [write](crate::codegen) it.
///
/// The table has [`LEVELS`](Self::LEVELS) levels. Their width is 2^-10 of full scale for irradiances
/// below 1/4, 2^-8 below 1 and 2^-6 below 4. From 4 on, a pixel shows the last level.
///
/// ```
/// use luminaire::{Rgb, display::Rgb565Ramp};
/// // A brick wall, in ambient light of 0.05 and a warm light.
/// let (wall, light) = (Rgb::new(0.5, 0.2, 0.1), Rgb::new(1.0, 0.8, 0.6));
/// let ramp = Rgb565Ramp::new(wall.map(|channel| 0.05 * channel), wall.zip(light, |a, b| a * b))?;
/// assert_eq!(ramp.pixel::<f32>(3.0, 3, 5).to_codes().red, 255);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Rgb565Ramp {
    /// For each level, the three channels in 32nds of a step: green in the upper eleven bits, red from bit
    /// 11 to bit 20, blue in the lower ten bits. One shift then brings the codes of red and blue to their
    /// places in a pixel.
    levels: [u32; Self::LEVELS],
}

impl Rgb565Ramp {
    /// The number of levels.
    pub const LEVELS: usize = 640;

    /// Computes the table of a surface: `base` is its linear light without the light, such as
    /// reflected ambient light, and `reflected` is what it adds for an irradiance of 1, which is the
    /// product of its colour and the light's.
    ///
    /// The sum is clipped at full scale. Before the dither, the error of a channel is at most 0.42
    /// steps of RGB565 (searched), and at most 0.24 steps where `base` is at least 0.01: half of a level
    /// over the narrowest step of green that it can meet, and the 1/64 step of the dither. Without the
    /// light it is at most 1/64 step.
    ///
    /// # Errors
    /// A channel outside 0 to 1.
    pub fn new(base: Rgb<f32>, reflected: Rgb<f32>) -> Result<Self, Error> {
        let (base, reflected) = (checked_color(base)?, checked_color(reflected)?);
        let levels = array::from_fn(|level| {
            let light = middle(level);
            let sum = base.zip(reflected, |base, reflected| base + light * reflected);
            steps::<63>(sum.green) << 21 | steps::<31>(sum.red) << 11 | steps::<31>(sum.blue)
        });
        Ok(Self { levels })
    }

    /// Creates a table from its levels, as [`codegen`](crate::codegen) writes them.
    pub const fn from_levels(levels: [u32; Self::LEVELS]) -> Self {
        Self { levels }
    }

    /// Returns the levels.
    pub const fn levels(&self) -> &[u32; Self::LEVELS] {
        &self.levels
    }

    /// Returns the pixel at `(x, y)` of a surface that receives an irradiance.
    ///
    /// The dither is that of [`Rgb565::from_linear_dithered`], with a resolution of 1/32 step. For
    /// each pixel the codes are monotone in the irradiance.
    #[inline(always)] // As the other functions of the dither.
    pub fn pixel<S: Scalar>(&self, irradiance: S::Irradiance, x: u32, y: u32) -> Rgb565 {
        // The channels do not overflow into each other: with the largest fraction, 31/32, a channel
        // is at most its last code and 31/32, and the last code has no fraction.
        let sum = self.levels[level(S::light_steps(irradiance))]
            .wrapping_add(OFFSETS[(y % 8) as usize][(x % 8) as usize]);
        Rgb565((sum >> 5 & 0xf81f | sum >> 26 << 5) as u16)
    }
}

/// Half the width of the narrowest level, in steps of 2^-14: the first level is that of darkness.
const HALF: u32 = 8;

/// Returns the level of an irradiance in steps of 2^-14.
#[inline(always)]
const fn level(light: u32) -> usize {
    const END: u32 = (1 << 16) - HALF;
    let place = light.wrapping_add(HALF);
    // At a limit the two formulas agree, so the limits need not be moved by `HALF`.
    (match light {
        0..0x1000 => place >> 4,
        0x1000..0x4000 => 192 + (place >> 6),
        0x4000..END => 384 + (place >> 8),
        END.. => 639,
    }) as usize
}

/// Returns the irradiance in the middle of a level, in the first level 0.
fn middle(level: usize) -> f32 {
    let place = level as f32 + 0.5;
    let place = match level {
        0..256 => place / 1024.0,
        256..448 => (place - 192.0) / 256.0,
        _ => (place - 384.0) / 64.0,
    };
    place - HALF as f32 / 16_384.0
}

/// Returns a linear value between the codes of a channel, in 32nds of a step, rounded to nearest.
///
/// As in the dither, the place between two codes is that in linear light.
fn steps<const LAST: usize>(value: f32) -> u32 {
    let value = clamp(value);
    let lights = CodeLight::<Srgb, LAST>::FLOAT.into_iter().enumerate();
    let (code, from) = lights.take_while(|(_, light)| *light <= value).last().unwrap_or_default();
    let to = CodeLight::<Srgb, LAST>::FLOAT.get(code + 1).copied().unwrap_or(1.0);
    32 * code as u32 + (32.0 * (value - from) / (to - from) + 0.5) as u32
}

/// What is added to the channels of a pixel before their fractions are cut off, in 32nds of a step.
const OFFSETS: [[u32; 8]; 8] = {
    let mut offsets = [[0; 8]; 8];
    let mut place = 0;
    while place < 64 {
        let (x, y) = (place % 8, place / 8);
        // Thresholds are odd numbers of 128ths: the offsets are 31 for the first to 0 for the last.
        let offset = (127 - dither::MATRIX[y][x] as u32) / 4;
        offsets[y][x] = offset << 21 | offset << 11 | offset;
        place += 1;
    }
    offsets
};
