//! Ordered dither: each pixel shows one of the two codes about a colour, so that together they have its light.
//!
//! Rounded to the few codes of a display, a soft gradient falls apart into bands. Between two codes a part of the
//! pixels shows the upper one instead, in the order of Bayer's matrix, which spreads them evenly over cells of
//! 8 x 8 (B. E. Bayer, *An optimum method for two-level rendition of continuous-tone pictures*, ICC 1973).
//!
//! How many they are goes by linear light, because that is what an eye adds up that does not see the pixels
//! apart: a quarter of the way from one code's light to the next one's, a quarter of the pixels. Parts by the
//! encoded value would make a cell too bright, in the dark by up to a twentieth of a step, and would need the
//! encoded value. Linear light needs no more than the light of each code, which is a table.
//!
//! There is no amplitude. All of the dither keeps the light, none of it ([`encode_srgb`](super::encode_srgb),
//! [`Rgb565::from_linear`]) puts the nearest code everywhere, and anything between would have bands again.

use super::{
    Rgb565,
    srgb::{curve, linear},
};
use crate::{
    color::Rgb,
    number::{Scalar, Word, float::clamp},
};

/// The sRGB code that a pixel shows of a linear value: one of the two about it, the same one for the same last three
/// bits of `x` and `y`. Below 0, and for what is not a number, it is 0; above 1 it is 255.
///
/// Over a cell of 8 x 8 pixels the mean light of the codes is that of the value within 0.0081 of the step from one
/// code to the next: 1/128, and the roundings of the table. A value nearer than that to a code's own light shows
/// the code in every pixel. For each pixel the code never falls as the value rises. Channels of one value have one
/// code, so that grey stays grey.
///
/// ```
/// use luminaire::display::{decode_srgb, encode_srgb_dithered};
/// let (four, five) = (decode_srgb(4), decode_srgb(5));
/// let quarter = four + 0.25 * (five - four);
/// let cell = (0..64).map(|i| encode_srgb_dithered(quarter, i % 8, i / 8));
/// assert_eq!(cell.filter(|&code| code == 5).count(), 16);
/// ```
#[inline]
pub fn encode_srgb_dithered<S: Scalar>(linear: S, x: u32, y: u32) -> u8 {
    dithered::<S, 255>(linear, threshold(x, y))
}

impl Rgb565 {
    /// The pixel that stands for a linear colour at a place in the picture, each channel as
    /// [`encode_srgb_dithered`] has it, with the codes of five and six bits.
    #[inline(always)] // `rgb565-dithered` on Cortex-M0: +5 without.
    pub fn from_linear_dithered<S: Scalar>(color: Rgb<S>, x: u32, y: u32) -> Self {
        let threshold = threshold(x, y);
        let red = dithered::<S, 31>(color.red, threshold);
        let green = dithered::<S, 63>(color.green, threshold);
        let blue = dithered::<S, 31>(color.blue, threshold);
        Self::pack(red.into(), green.into(), blue.into())
    }
}

/// One of the codes from 0 to `LAST` about a linear value, clamped to [0, 1]: the upper one where the light is past
/// `threshold` 128ths of the way from the lower one's to its own.
#[inline]
fn dithered<S: Scalar, const LAST: usize>(linear: S, threshold: u8) -> u8 {
    match linear.word() {
        Word::Single(linear) => dithered_float::<LAST>(linear, threshold),
        #[cfg(feature = "fixed")]
        Word::Steps14(linear) => {
            dithered_fixed::<LAST>(u32::from(linear.clamp(0, 1 << 14) as u16) << 10, threshold)
        }
        #[cfg(feature = "fixed")]
        Word::Steps30(linear) => dithered_fixed::<LAST>(linear.clamp(0, 1 << 30) as u32 >> 6, threshold),
    }
}

/// How far towards the next code a pixel stays with its code, in 128ths.
#[inline]
fn threshold(x: u32, y: u32) -> u8 {
    MATRIX[(y % 8) as usize][(x % 8) as usize]
}

/// Bayer's matrix of 0 to 63, each as the middle of its 64th.
const MATRIX: [[u8; 8]; 8] = {
    let mut matrix = [[0; 8]; 8];
    let mut place = 0;
    while place < 64 {
        let (x, y) = (place % 8, place / 8);
        matrix[y][x] = 2 * rank(x, y) + 1;
        place += 1;
    }
    matrix
};

/// When a pixel's turn comes. The lowest bits of the place decide most, so that neighbours are far apart.
const fn rank(x: usize, y: usize) -> u8 {
    let (mut rank, mut bit) = (0, 0);
    while bit < 3 {
        let pair = ((x ^ y) >> bit & 1) << 1 | y >> bit & 1;
        rank = rank << 2 | pair;
        bit += 1;
    }
    rank as u8
}

/// The fraction bits of the table: as many as an f32 has below one, and few enough that 128 such steps fit 32 bits.
const BITS: u32 = 24;
/// The light of a code from 0 to `last`, as the nearest multiple of 2^-24.
const fn light(code: usize, last: usize) -> u32 {
    (linear(code as f64 / last as f64) * (1 << BITS) as f64 + 0.5) as u32
}

/// The light of the codes up to `LAST`.
struct CodeLight<const LAST: usize>;

impl<const LAST: usize> CodeLight<LAST> {
    /// From code 1 on, in steps of 2^-24.
    #[cfg(feature = "fixed")]
    const STEPS: [u32; LAST] = {
        let mut table = [0; LAST];
        let mut code = 0;
        while code < LAST {
            table[code] = light(code + 1, LAST);
            code += 1;
        }
        table
    };

    /// From code 0 on, exactly that; the last one's is one.
    const FLOAT: [f32; LAST] = {
        let mut table = [0.0; LAST];
        let mut code = 0;
        while code < LAST {
            table[code] = light(code, LAST) as f32 / (1 << BITS) as f32;
            code += 1;
        }
        table
    };
}

/// The code of a value in steps of 2^-24, of which there are at most 2^24: found by halving the codes that
/// are left, and one more where the value is past the threshold.
#[cfg(feature = "fixed")]
#[inline]
fn dithered_fixed<const LAST: usize>(linear: u32, threshold: u8) -> u8 {
    let mut left = CodeLight::<LAST>::STEPS.as_slice();
    let (mut code, mut here, mut next) = (0, 0, 1 << BITS);
    // As many turns as the code has bits: a number that the compiler knows, and unrolls.
    for _ in 0..=LAST.ilog2() {
        let (below, [light, above @ ..]) = left.split_at(left.len() / 2) else { break };
        if linear >= *light {
            (left, here) = (above, *light);
            code += below.len() + 1;
        } else {
            (left, next) = (below, *light);
        }
    }
    let is_past = (linear - here) << 7 > (next - here) * u32::from(threshold);
    (code + usize::from(is_past)) as u8
}

/// The same in f32, where the curve finds the nearest code, or at worst the other one about the
/// value. The code is the fixed-point one of an equal value but where the product rounds: within
/// 2^-24 of the way to a threshold.
#[inline]
fn dithered_float<const LAST: usize>(linear: f32, threshold: u8) -> u8 {
    let linear = clamp(linear);
    let light = |code: usize| CodeLight::<LAST>::FLOAT.get(code).copied().unwrap_or(1.0);
    let near = (curve(linear, LAST as f32) + 0.5) as i32 as usize;
    let code = near.saturating_sub(usize::from(linear < light(near))).min(LAST - 1);
    let (here, next) = (light(code), light(code + 1));
    let is_past = (linear - here) * 128.0 > (next - here) * f32::from(threshold);
    (code + usize::from(is_past)) as u8
}
