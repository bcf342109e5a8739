//! Dithered pixels of surfaces of one colour, from a table.

use core::{array, marker::PhantomData};

use super::{
    levels::{offsets, packed, shown},
    pixel::{Pixel, Rgb565},
};
use crate::{
    color::{Rgb, checked_color},
    error::Error,
    number::Scalar,
};

/// A surface of one colour under lights of one colour: its dithered pixels by the irradiance.
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
/// use luminaire::{Rgb, display::Rgb565Ramp}; // for other pixels, `Ramp<P>`
/// // A brick wall, in ambient light of 0.05 and a warm light.
/// let (wall, light) = (Rgb::new(0.5, 0.2, 0.1), Rgb::new(1.0, 0.8, 0.6));
/// let ramp = Rgb565Ramp::new(wall.map(|channel| 0.05 * channel), wall.zip(light, |a, b| a * b))?;
/// assert_eq!(ramp.pixel::<f32>(3.0, 3, 5).to_codes().red, 255);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Ramp<P> {
    levels: [u32; LEVELS],
    pixels: PhantomData<P>,
}

/// The ramp of most colour displays.
pub type Rgb565Ramp = Ramp<Rgb565>;

const LEVELS: usize = 640;
const _: () = assert!(size_of::<Rgb565Ramp>() == 2_560, "as its documentation states");

impl<P: Pixel> Ramp<P> {
    /// The number of levels.
    pub const LEVELS: usize = LEVELS;

    /// Computes the table of a surface: `base` is its linear light without the light, such as
    /// reflected ambient light, and `reflected` is what it adds for an irradiance of 1, which is the
    /// product of its colour and the light's.
    ///
    /// The sum is clipped at full scale. Before the dither, the error of a channel is at most that of
    /// half a level of the irradiance, and `2^-(f + 1)` steps with the fraction bits `f` of a channel in
    /// the table: `min(5, (32 - P::BITS) / 3)`, rounded down. In RGB565 that is at most 0.42 steps
    /// (searched), and at most 0.24 steps where `base` is at least 0.01. Without the light only the
    /// fraction is rounded: by at most 1/64 step in RGB565, 1/8 step in RGB888.
    ///
    /// # Errors
    /// A channel outside 0 to 1.
    pub fn new(base: Rgb<f32>, reflected: Rgb<f32>) -> Result<Self, Error> {
        let (base, reflected) = (checked_color(base)?, checked_color(reflected)?);
        let levels = array::from_fn(|level| {
            let light = middle(level);
            packed::<P>(base.zip(reflected, |base, reflected| base + light * reflected))
        });
        Ok(Self::from_levels(levels))
    }

    /// Creates a table from its levels, as [`codegen`](crate::codegen) writes them.
    pub const fn from_levels(levels: [u32; LEVELS]) -> Self {
        Self { levels, pixels: PhantomData }
    }

    /// Returns the levels.
    pub const fn levels(&self) -> &[u32; LEVELS] {
        &self.levels
    }

    /// Returns the pixel at `(x, y)` of a surface that receives an irradiance.
    ///
    /// The dither is that of [`Pixel::dithered`], with the fraction bits of [`new`](Self::new). For each
    /// pixel the codes are monotone in the irradiance.
    #[inline(always)] // As the other functions of the dither.
    pub fn pixel<S: Scalar>(&self, irradiance: S::Irradiance, x: u32, y: u32) -> P {
        shown(self.levels[level(S::light_steps(irradiance))], offsets::<P>(y)[(x % 8) as usize])
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
