//! The nearest code, by the exact thresholds between codes, and the sRGB encoding (IEC 61966-2-1).
//!
//! In f32 a polynomial selects the threshold of sRGB with which the value is compared. In fixed
//! point, and for powers, a bisection finds the threshold.

use core::marker::PhantomData;

use super::{
    curve::{Encoding, Srgb, Transfer, linear},
    pwm,
};
use crate::{
    number::{HAS_VECTORS, Scalar, Word, float::clamp},
    trig,
};

/// Upper end of the linear segment of the sRGB curve, in linear light.
pub(super) const TOE: f32 = 0.003_130_8;

/// The curved part of the sRGB encoding, as a polynomial in the square root of the linear value.
///
/// Coefficients start with the constant term. Minimax fit of degree 4, in codes of 1/255, to
/// `255 (1.055 x^(1/2.4) - 0.055)`, with an error of at most 0.2 codes. An error below 0.5 codes
/// suffices, because the polynomial only selects a threshold, and the comparison with this
/// threshold determines the code.
const ENCODE: [f32; 5] = [-9.436_19, 369.214_33, -240.939_53, 214.911_74, -78.940_82];

/// Returns the sRGB code of a linear value.
///
/// The code is 0 for NaN and values up to 0, and 255 for values from 1 on. The result is exactly
/// the nearest code, for every value of every format. Fixed point compares integers only; f32 uses
/// a square root, a polynomial and one comparison instead of the power 1/2.4.
///
/// ```
/// assert_eq!([0.0, 0.5, 1.0].map(luminaire::display::encode_srgb::<f32>), [0, 188, 255]);
/// ```
#[inline]
pub fn encode_srgb<S: Scalar>(linear: S) -> u8 {
    nearest_code::<S, Srgb, 255>(linear)
}

/// Returns the sRGB codes of linear values: for each value the code of [`encode_srgb`].
///
/// The polynomials of all values come first, then the look-ups in the table of thresholds, then the
/// comparisons, so that compilers use vector instructions for all but the look-ups. Fixed point takes this
/// way, too, on processors with vectors of floats; on others it takes [`encode_srgb`].
#[inline]
pub fn encode_srgb_each<S: Scalar, const N: usize>(linear: &[S; N]) -> [u8; N] {
    if !by_floats::<S>() {
        return linear.map(encode_srgb);
    }
    let mut near = [0; N];
    for (near, linear) in near.iter_mut().zip(linear) {
        *near = nearest_integer(curve(clamp(linear.word().single()), 255.0) - 0.5);
    }
    let thresholds = near.map(|code| EIGHT_BIT_THRESHOLDS[code as u8 as usize]);
    let mut codes = [0; N];
    for i in 0..N {
        let reaches = match linear[i].word() {
            // The f32 of 30 bits is rounded: the integers decide.
            #[cfg(feature = "fixed")]
            Word::Steps30(linear) => {
                let thresholds = &Thresholds::<Srgb, 255>::THIRTY_TWO;
                thresholds.get(near[i] as usize).is_some_and(|threshold| linear >= *threshold as i32)
            }
            word => clamp(word.single()) >= thresholds[i],
        };
        codes[i] = (near[i] + u32::from(reaches)) as u8;
    }
    codes
}

/// Returns whether many values of a format are encoded by a polynomial in f32: those of `f32`, and all
/// formats on processors whose vector instructions have floats.
pub(super) fn by_floats<S: Scalar>() -> bool {
    HAS_VECTORS || !S::SKIPS
}

/// The thresholds of all codes of eight bits. No light reaches the one after the last code.
static EIGHT_BIT_THRESHOLDS: [f32; 256] = {
    let mut table = [f32::INFINITY; 256];
    let mut code = 0;
    while code < 255 {
        table[code] = Thresholds::<Srgb, 255>::FLOAT[code];
        code += 1;
    }
    table
};

/// Returns the integer nearest to a value up to 255; 0 for values below 0.
#[inline(always)]
pub(super) fn nearest_integer(value: f32) -> u32 {
    /// From this number to its double, an f32 has steps of 1. So the sum of a value and this number
    /// has the rounded value in its low bits. Every vector instruction set has this conversion by
    /// addition, and it needs no test for overflow.
    const INTEGERS: f32 = 8_388_608.0;
    ((if value > 0.0 { value } else { 0.0 }) + INTEGERS).to_bits() & 0xff
}

/// Counts the thresholds that a linear value reaches, by bisection.
///
/// The number of comparisons is the number of bits of the code, for every value.
macro_rules! code {
    ($thresholds:expr, $linear:expr) => {{
        let (thresholds, linear) = ($thresholds, $linear);
        let (mut code, mut step) = (0, thresholds.len().div_ceil(2));
        while step > 0 {
            // The index is always in bounds, but the compiler cannot prove this. An index
            // expression would add a panic.
            let reaches = thresholds.get(code + step - 1).is_some_and(|threshold| linear >= *threshold);
            code += if reaches { step } else { 0 };
            step /= 2;
        }
        code as u8
    }};
}

/// Returns the code of a curve in `[0, LAST]` nearest to a linear value.
#[inline]
pub(super) fn nearest_code<S: Scalar, L: Encoding, const LAST: usize>(linear: S) -> u8 {
    nearest_of_word::<L, LAST>(linear.word())
}

/// Returns the code in `[0, LAST]` nearest to the linear value in a word.
#[inline(always)] // A format has one kind of word: the other arms are removed before a caller inlines this.
pub(super) fn nearest_of_word<L: Encoding, const LAST: usize>(linear: Word) -> u8 {
    if let Transfer::Linear = L::TRANSFER {
        return pwm::nearest(linear, LAST.count_ones()) as u8;
    }
    match linear {
        Word::Single(linear) => encode_float::<L, LAST>(linear),
        #[cfg(feature = "fixed")]
        Word::Steps14(linear) => encode_steps14::<L, LAST>(linear),
        #[cfg(feature = "fixed")]
        Word::Steps30(linear) => encode_steps30::<L, LAST>(linear),
    }
}

/// Returns the code in `[0, LAST]` nearest to a linear value in f32.
#[inline]
fn encode_float<L: Encoding, const LAST: usize>(linear: f32) -> u8 {
    let linear = clamp(linear);
    let thresholds = &Thresholds::<L, LAST>::FLOAT;
    let Transfer::Srgb = L::TRANSFER else { return code!(thresholds, linear) };
    let code = curve(linear, LAST as f32) as i32 as usize;
    // The threshold between the two codes around the value. For a value near the light of a code,
    // the polynomial may select the threshold on the other side of that code. The comparison with
    // the threshold below the code's light and the comparison with the threshold above give the
    // same code. Beyond the last threshold `get` returns `None`; an index expression would panic.
    let reaches = thresholds.get(code).is_some_and(|threshold| linear >= *threshold);
    (code + usize::from(reaches)) as u8
}

/// Returns the approximate position of a value in `[0, 1]` among the codes in `[0, last]`.
///
/// The error is at most 0.2 of a code of 1/255.
#[inline]
pub(super) fn curve(linear: f32, last: f32) -> f32 {
    let curve = polynomial(ENCODE, trig::sqrt(linear));
    let code = if linear < TOE { 255.0 * 12.92 * linear } else { curve };
    code * (last / 255.0)
}

/// Returns a linear value just below the threshold between the codes 0 and 1 of sRGB, by 2^-21 of it:
/// the sum of a luminance may round up.
pub(super) const fn first_step(last: u32) -> f32 {
    let threshold = linear(Transfer::Srgb, 0.5 / last as f64);
    (threshold * (1.0 - 1.0 / (1 << 21) as f64)) as f32
}

/// Evaluates a polynomial by Horner's rule.
#[inline]
pub(super) fn polynomial<const N: usize>(coefficients: [f32; N], x: f32) -> f32 {
    coefficients.into_iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

/// Thresholds between the codes of a curve in `[0, LAST]`.
///
/// The threshold at an index is the smallest linear value of the format whose nearest code is one
/// more than the index. A table is only linked for a curve and a `LAST` that are used.
struct Thresholds<L, const LAST: usize>(PhantomData<L>);

/// Builds a table from an expression that is evaluated for each threshold in f64.
macro_rules! of_each {
    ($zero:expr, $threshold:ident => $entry:expr) => {{
        let mut table = [$zero; LAST];
        let mut code = 0;
        while code < LAST {
            let $threshold = linear(L::TRANSFER, (code as f64 + 0.5) / LAST as f64);
            table[code] = $entry;
            code += 1;
        }
        table
    }};
}

impl<L: Encoding, const LAST: usize> Thresholds<L, LAST> {
    const FLOAT: [f32; LAST] = of_each!(0.0, threshold => {
        let nearest = threshold as f32;
        if (nearest as f64) < threshold { f32::from_bits(nearest.to_bits() + 1) } else { nearest }
    });

    /// The thresholds in units of 2^-14: two bytes per code.
    #[cfg(feature = "fixed")]
    const SIXTEEN: [u16; LAST] = of_each!(0, threshold => steps(threshold, 14) as u16);

    /// The thresholds in units of 2^-30.
    #[cfg(feature = "fixed")]
    const THIRTY_TWO: [u32; LAST] = of_each!(0, threshold => steps(threshold, 30));
}

/// Returns the thresholds in units of 2^-14 and in units of 2^-30.
#[cfg(all(feature = "arithmetic", feature = "fixed"))]
pub(crate) const fn code_thresholds<L: Encoding, const LAST: usize>() -> (&'static [u16], &'static [u32]) {
    (&Thresholds::<L, LAST>::SIXTEEN, &Thresholds::<L, LAST>::THIRTY_TWO)
}

/// Converts a linear value to units of `2^-bits`, rounded up.
#[cfg(feature = "fixed")]
const fn steps(linear: f64, bits: u32) -> u32 {
    let exact = linear * (1_u32 << bits) as f64;
    let whole = exact as u32;
    if (whole as f64) < exact { whole + 1 } else { whole }
}

/// Returns the nearest code of a value in units of 2^-14.
#[cfg(feature = "fixed")]
#[inline]
fn encode_steps14<L: Encoding, const LAST: usize>(linear: i16) -> u8 {
    code!(&Thresholds::<L, LAST>::SIXTEEN, linear.max(0) as u16)
}

/// Returns the nearest code of a value in units of 2^-30.
#[cfg(feature = "fixed")]
#[inline]
fn encode_steps30<L: Encoding, const LAST: usize>(linear: i32) -> u8 {
    code!(&Thresholds::<L, LAST>::THIRTY_TWO, linear.max(0) as u32)
}
