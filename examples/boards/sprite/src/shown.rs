//! From the light of two lights to a pixel of 15 bits.
//!
//! Each light has 32 levels, which are those of an sRGB channel of five bits: so a step of a level is at most a step of
//! the display, in every material and beside any other light. The level is dithered; by it, the other light's and the
//! material a table has the pixel. It takes the place of six products with the colours of the lights, three with the
//! material's, and three encodings.

use crate::{
    measures::{LIGHT_LEVELS, MATERIALS, STEPS},
    word::Word,
};

/// The pixels of a material by the level of each light, in all materials.
pub type Pixels = [u16; MATERIALS * LIGHT_LEVELS * LIGHT_LEVELS];

/// The level of a light with three fraction bits, by its steps.
///
/// The upper half is for steps that are negative, modulo twice as many: a surface that faces away is dark.
pub type Steps = [u8; 2 * STEPS];

/// The pixels, with blue in the upper bits, as the console has them.
#[allow(
    clippy::large_const_arrays,
    reason = "firmware has it in a static of its own, in the memory that it chooses"
)]
pub const PIXELS: Pixels = include!(concat!(env!("OUT_DIR"), "/pixels.rs"));

/// The levels of light. Between those of two levels the fraction is linear in light, as in the kernel's dither.
pub const LEVEL: Steps = include!(concat!(env!("OUT_DIR"), "/levels.rs"));

/// The colours of the two lights, as pixels.
pub const LAMPS: [u16; 2] = include!(concat!(env!("OUT_DIR"), "/lamps.rs"));

static HERE: (Pixels, Steps) = (PIXELS, LEVEL);

/// The two tables.
#[derive(Clone, Copy, Debug)]
pub struct Shown<'a> {
    /// The pixels.
    pub pixels: &'a Pixels,
    /// The levels.
    pub levels: &'a Steps,
}

impl Shown<'static> {
    /// Returns the tables in read-only memory.
    pub fn new() -> Self {
        Self { pixels: &HERE.0, levels: &HERE.1 }
    }
}

impl Default for Shown<'static> {
    fn default() -> Self {
        Self::new()
    }
}

impl Shown<'_> {
    /// Returns the pixel that the steps of two lights have: each below [`STEPS`], or from there on to twice as
    /// many and dark.
    ///
    /// The second light has the complementary threshold: where the first is rounded up, it is rounded down, so that their
    /// sum is rougher by neither.
    #[inline(always)]
    pub fn pixel(&self, word: Word, [first, second]: [u32; 2]) -> u16 {
        let level = |steps: u32| u32::from(self.levels[steps as usize % (2 * STEPS)]);
        let threshold = word.threshold();
        let (first, second) = (level(first) + threshold, level(second) + (threshold ^ 7));
        let index = word.material() << 7 | (first & 0xf8) << 2 | second >> 3 & 0x1f;
        self.pixels[index as usize % (MATERIALS * LIGHT_LEVELS * LIGHT_LEVELS)]
    }
}
