//! Ordered dither: each pixel shows one of the two codes around a value; the mean light is correct.
//!
//! A display has few codes, so rounding to the nearest code turns a soft gradient into bands. With
//! dither, a share of the pixels shows the upper of the two codes around a value, and the other
//! pixels show the lower code. Bayer's matrix determines the order in which pixels get the upper
//! code, and spreads these pixels evenly over cells of 8 x 8 (B. E. Bayer, *An optimum method for
//! two-level rendition of continuous-tone pictures*, ICC 1973).
//!
//! The share is computed in linear light, because an eye that does not resolve the pixels adds
//! linear light. For a value at a quarter of the distance from the lower code's light to the upper
//! code's light, a quarter of the pixels shows the upper code. The alternative, a share computed
//! from the encoded value, would make a cell too bright, for dark colours by up to a twentieth of a
//! step between codes. The alternative would also need the encoding, whereas the share in linear
//! light only needs a table of the light of each code.
//!
//! There is no amplitude parameter. Full dither keeps the mean light. Without dither
//! ([`encode_srgb`](super::encode_srgb), [`Pixel::nearest`](super::Pixel::nearest)) each pixel shows the nearest
//! code. Any amplitude between no dither and full dither would show bands again.

use core::marker::PhantomData;

use super::{
    curve::{Encoding, Srgb, Transfer, linear},
    srgb::{by_floats, curve, nearest_integer},
};
use crate::number::{Scalar, Word, float::clamp};

/// Returns the sRGB code of a linear value for the pixel at `(x, y)`, with ordered dither.
///
/// The code is one of the two codes around the value, and depends only on the value and the last
/// three bits of `x` and `y`. The code is 0 for values below 0 and for NaN, and 255 for values
/// above 1.
///
/// Over a cell of 8 x 8 pixels the mean light of the codes equals the value, within 0.0081 of the
/// step from one code's light to the next: 1/128 plus the rounding error of the table. A value
/// within 1/128 of a step of a code's own light shows this code in every pixel. For each pixel the
/// code is monotone in the value. Channels of equal value have equal codes, so grey stays grey.
///
/// ```
/// use luminaire::display::{decode_srgb, encode_srgb_dithered};
/// let [four, five] = [4, 5].map(decode_srgb::<f32>);
/// let quarter = four + 0.25 * (five - four);
/// let cell = (0..64).map(|i| encode_srgb_dithered(quarter, i % 8, i / 8));
/// assert_eq!(cell.filter(|&code| code == 5).count(), 16);
/// ```
#[inline]
pub fn encode_srgb_dithered<S: Scalar>(linear: S, x: u32, y: u32) -> u8 {
    dithered::<S, Srgb, 255>(linear, threshold(x, y))
}

/// Returns the dithered sRGB codes of the linear values of neighbouring pixels, of which the first
/// is at `(x, y)`: for each pixel the code of [`encode_srgb_dithered`].
///
/// The polynomials of all values come first, then the look-ups, then the comparisons, so that compilers
/// use vector instructions for all but the look-ups. One value after another, half of the comparisons would
/// be mispredicted branches, because the result of each depends on its pixel. Fixed point takes this way,
/// too, on processors with vectors of floats.
#[inline]
pub fn encode_srgb_dithered_each<S: Scalar, const N: usize>(linear: &[S; N], x: u32, y: u32) -> [u8; N] {
    let row: [u8; 8] = core::array::from_fn(|i| threshold(x.wrapping_add(i as u32), y));
    if !by_floats::<S>() {
        return core::array::from_fn(|i| dithered::<S, Srgb, 255>(linear[i], row[i % 8]));
    }
    // One for each value: compilers do not vectorise the remainder of an index.
    let thresholds: [f32; N] = core::array::from_fn(|i| row[i % 8].into());
    let mut lower = [0; N];
    for ((lower, linear), threshold) in lower.iter_mut().zip(linear).zip(&thresholds) {
        // Within the error of the polynomial, the code is this number or the next.
        let code = curve(clamp(linear.word().single()), 255.0) - threshold / 128.0;
        *lower = nearest_integer(if code > 254.0 { 254.0 } else { code });
    }
    let steps = lower.map(|code| EIGHT_BIT_STEPS[code as u8 as usize]);
    let mut codes = [0; N];
    for i in 0..N {
        let (here, step) = steps[i];
        let is_past = match linear[i].word() {
            Word::Single(linear) => (clamp(linear) - here) * 128.0 > step * thresholds[i],
            // The products of integers do not round.
            #[cfg(feature = "fixed")]
            word => {
                let [here, step] = [here, step].map(|light| (light * (1 << BITS) as f32) as i32);
                (word.steps24() as i32 - here) * 128 > step * thresholds[i] as i32
            }
        };
        codes[i] = (lower[i] + u32::from(is_past)) as u8;
    }
    codes
}

/// The light of each code of eight bits, and the step to the light of the next code.
static EIGHT_BIT_STEPS: [(f32, f32); 256] = {
    let mut table = [(1.0, 0.0); 256];
    let mut code = 0;
    while code < 255 {
        let here = CodeLight::<Srgb, 255>::FLOAT[code];
        let next = if code < 254 { CodeLight::<Srgb, 255>::FLOAT[code + 1] } else { 1.0 };
        table[code] = (here, next - here);
        code += 1;
    }
    table
};

/// Returns one of the two codes in `[0, LAST]` around a linear value clamped to `[0, 1]`.
///
/// The result is the upper code if the value is more than `threshold / 128` of the way from the
/// light of the lower code to the light of the upper code.
#[inline]
pub(super) fn dithered<S: Scalar, L: Encoding, const LAST: usize>(linear: S, threshold: u8) -> u8 {
    dithered_word::<L, LAST>(linear.word(), threshold)
}

/// Returns the code of [`dithered`] for the linear value in a word.
#[inline(always)] // A format has one kind of word: the other arms are removed before a caller inlines this.
pub(super) fn dithered_word<L: Encoding, const LAST: usize>(linear: Word, threshold: u8) -> u8 {
    match linear {
        Word::Single(linear) => dithered_float::<L, LAST>(linear, threshold),
        #[cfg(feature = "fixed")]
        word => dithered_fixed::<L, LAST>(word.steps24(), threshold),
    }
}

/// Returns the dither's threshold of the pixel at `(x, y)`, for other outputs: an odd number of
/// 128ths, from 1 to 127, of the step from one code's light to the next.
///
/// A pixel shows the upper code if its value is farther than this from the lower code. Each of the
/// 64 thresholds occurs once in each cell of 8 x 8 pixels, in the order of Bayer's matrix.
#[inline]
pub fn threshold(x: u32, y: u32) -> u8 {
    MATRIX[(y % 8) as usize][(x % 8) as usize]
}

/// Bayer's matrix of the ranks 0 to 63. Each rank is stored as the threshold `2 rank + 1` in
/// 128ths: the middle of the 64th part with this rank.
pub(super) const MATRIX: [[u8; 8]; 8] = {
    let mut matrix = [[0; 8]; 8];
    let mut place = 0;
    while place < 64 {
        let (x, y) = (place % 8, place / 8);
        matrix[y][x] = 2 * rank(x, y) + 1;
        place += 1;
    }
    matrix
};

/// Returns the rank of a pixel in Bayer's order.
///
/// The lowest bits of the coordinates become the highest bits of the rank, so that neighbouring
/// pixels have distant ranks.
const fn rank(x: usize, y: usize) -> u8 {
    let (mut rank, mut bit) = (0, 0);
    while bit < 3 {
        let pair = ((x ^ y) >> bit & 1) << 1 | y >> bit & 1;
        rank = rank << 2 | pair;
        bit += 1;
    }
    rank as u8
}

/// Fraction bits of the table of the light of each code: the precision of an f32 below 1.
///
/// With 24 bits, 128 times a difference of two table values fits 32 bits.
pub(super) const BITS: u32 = 24;

/// Returns the light of a code in `[0, last]`, as the nearest multiple of 2^-24.
pub(super) const fn light(transfer: Transfer, code: usize, last: usize) -> u32 {
    (linear(transfer, code as f64 / last as f64) * (1 << BITS) as f64 + 0.5) as u32
}

/// Tables of the light of a curve's codes up to `LAST`.
struct CodeLight<L, const LAST: usize>(PhantomData<L>);

impl<L: Encoding, const LAST: usize> CodeLight<L, LAST> {
    /// The light of the codes from 1 on, in units of 2^-24.
    const STEPS: [u32; LAST] = {
        let mut table = [0; LAST];
        let mut code = 0;
        while code < LAST {
            table[code] = light(L::TRANSFER, code + 1, LAST);
            code += 1;
        }
        table
    };

    /// The light of the codes from 0 to `LAST - 1`, exactly the values of the fixed-point table.
    /// The light of code `LAST` is 1.
    const FLOAT: [f32; LAST] = {
        let mut table = [0.0; LAST];
        let mut code = 0;
        while code < LAST {
            table[code] = light(L::TRANSFER, code, LAST) as f32 / (1 << BITS) as f32;
            code += 1;
        }
        table
    };
}

/// Returns the light of an sRGB code, in units of 2^-24.
#[inline]
pub(super) fn srgb_light(code: u8) -> u32 {
    let lights = &CodeLight::<Srgb, 255>::STEPS;
    usize::from(code).checked_sub(1).and_then(|index| lights.get(index)).copied().unwrap_or(0)
}

/// Returns the light of the codes from 1 on, in units of 2^-24.
#[cfg(all(feature = "arithmetic", feature = "fixed"))]
pub(crate) const fn code_lights<L: Encoding, const LAST: usize>() -> &'static [u32] {
    &CodeLight::<L, LAST>::STEPS
}

/// Returns a linear value between the codes of a channel, in steps with fraction bits, rounded to
/// nearest.
///
/// As in the dither, the place between two codes is that in linear light.
pub(super) fn steps<const LAST: usize>(value: f32, fraction: u32) -> u32 {
    let (value, parts) = (clamp(value), (1_u32 << fraction) as f32);
    let lights = CodeLight::<Srgb, LAST>::FLOAT.into_iter().enumerate();
    let (code, from) = lights.take_while(|(_, light)| *light <= value).last().unwrap_or_default();
    let to = CodeLight::<Srgb, LAST>::FLOAT.get(code + 1).copied().unwrap_or(1.0);
    ((code as u32) << fraction) + (parts * (value - from) / (to - from) + 0.5) as u32
}

/// Returns the dithered code of a value in units of 2^-24, at most 2^24.
///
/// A bisection finds the lower of the two codes around the value. The result is the upper code if
/// the value is past the threshold.
#[cfg(feature = "fixed")]
#[inline]
fn dithered_fixed<L: Encoding, const LAST: usize>(linear: u32, threshold: u8) -> u8 {
    let mut left = CodeLight::<L, LAST>::STEPS.as_slice();
    let (mut code, mut here, mut next) = (0, 0, 1 << BITS);
    // One iteration per bit of the code: a constant, so the compiler unrolls the loop.
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

/// Returns the dithered code of a value in f32.
///
/// For sRGB a polynomial gives the nearest code or, at worst, the other of the two codes around the
/// value; for other curves a bisection finds the lower code.
/// The result equals that of `dithered_fixed` for the same value. The only exceptions are values so
/// near a threshold, within a relative 2^-24, that the products in the comparison round.
#[inline]
fn dithered_float<L: Encoding, const LAST: usize>(linear: f32, threshold: u8) -> u8 {
    let linear = clamp(linear);
    let light = |code: usize| CodeLight::<L, LAST>::FLOAT.get(code).copied().unwrap_or(1.0);
    let code = if let Transfer::Srgb = L::TRANSFER {
        let near = (curve(linear, LAST as f32) + 0.5) as i32 as usize;
        near.saturating_sub(usize::from(linear < light(near))).min(LAST - 1)
    } else {
        CodeLight::<L, LAST>::FLOAT.partition_point(|light| *light <= linear).saturating_sub(1)
    };
    let (here, next) = (light(code), light(code + 1));
    let is_past = (linear - here) * 128.0 > (next - here) * f32::from(threshold);
    (code + usize::from(is_past)) as u8
}
