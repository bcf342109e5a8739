//! The sRGB encoding (IEC 61966-2-1): by a polynomial in f32, by comparisons of integers in fixed point.

use crate::{
    scalar::{Scalar, float::clamp},
    trig,
};

/// Where the straight toe of the sRGB curve ends, in linear light.
const TOE: f32 = 0.003_130_8;

/// The curved part of sRGB in codes, as a polynomial in the fourth root of the linear value, from the constant
/// upwards: the minimax fit of degree 5 to `255 (1.055 x^(1/2.4) - 0.055)`.
const ENCODE: [f32; 6] = [-15.641_76, 41.316_7, 320.128_1, -147.258_1, 73.830_95, -17.377_57];

/// The inverse, `((v + 0.055) / 1.055)^2.4` for v in [0, 1], from the constant upwards: the minimax fit of degree 7.
const DECODE: [f32; 8] = [
    0.000_870_130_95,
    0.034_664_018,
    0.494_245_95,
    0.804_610_3,
    -0.663_287_1,
    0.544_319_1,
    -0.277_593_4,
    0.062_172_695,
];

/// The sRGB code of a linear value: 0 for 0 and below, 255 for 1 and above; what is not a number becomes 0.
///
/// In fixed point exactly the nearest code, by comparisons of integers alone. In f32 two square roots and a polynomial
/// in place of the power 1/2.4: before it is rounded the code is within 0.002 of the exact one (searched), so that at
/// most one value in 250 rounds the other way.
///
/// ```
/// assert_eq!([0.0, 0.5, 1.0].map(luminaire::encode_srgb::<f32>), [0, 188, 255]);
/// ```
#[inline(always)]
pub fn encode_srgb<S: Scalar>(linear: S) -> u8 {
    linear.srgb::<255>()
}

/// The nearest code of f32, from 0 to `last`.
#[inline(always)]
pub(crate) fn encode_float(linear: f32, last: f32) -> u8 {
    (curve(clamp(linear), last) + 0.5) as i32 as u8
}

/// The place of a value from 0 to 1 among the codes from 0 to `last`, before it is rounded.
#[inline(always)]
pub(super) fn curve(linear: f32, last: f32) -> f32 {
    let curve = polynomial(ENCODE, trig::sqrt(trig::sqrt(linear)));
    let code = if linear < TOE { 255.0 * 12.92 * linear } else { curve };
    code * (last / 255.0)
}

/// The linear value of an sRGB code, in [0, 1], within 2e-6 (exhaustive). For set-up: encoding gives the code back.
pub fn decode_srgb(code: u8) -> f32 {
    let value = f32::from(code) / 255.0;
    if value <= 12.92 * TOE { value / 12.92 } else { clamp(polynomial(DECODE, value)) }
}

/// Horner's rule.
#[inline(always)]
fn polynomial<const N: usize>(coefficients: [f32; N], x: f32) -> f32 {
    coefficients.into_iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

/// The thresholds between the codes from 0 to `LAST`: the least linear value, in steps of a format, whose nearest code is
/// one more than the index.
#[cfg(feature = "fixed")]
struct Thresholds<const LAST: usize>;

#[cfg(feature = "fixed")]
impl<const LAST: usize> Thresholds<LAST> {
    /// In steps of 2^-14: two bytes a code, and only for those `LAST` that are asked for.
    const SIXTEEN: [u16; LAST] = {
        let mut table = [0; LAST];
        let mut code = 0;
        while code < LAST {
            table[code] = threshold(code, LAST, 14) as u16;
            code += 1;
        }
        table
    };

    /// In steps of 2^-30.
    const THIRTY_TWO: [u32; LAST] = {
        let mut table = [0; LAST];
        let mut code = 0;
        while code < LAST {
            table[code] = threshold(code, LAST, 30);
            code += 1;
        }
        table
    };
}

/// The least multiple of `2^-bits` whose sRGB value is not under `(code + 1/2) / last`.
#[cfg(feature = "fixed")]
const fn threshold(code: usize, last: usize, bits: u32) -> u32 {
    least((code as f64 + 0.5) / last as f64, bits)
}

/// The least multiple of `2^-bits`, of those above 0, whose sRGB value is not under this one, by bisection.
///
/// The curve is `x = v^(12/5)`, so that `x >= v^(12/5)` is `x^5 >= v^12`: a comparison of products.
pub(super) const fn least(value: f64, bits: u32) -> u32 {
    let base = (value + 0.055) / 1.055;
    let cube = base * base * base;
    let twelfth = cube * cube * cube * cube;
    let (mut below, mut above) = (0, 1_u32 << bits);
    while above - below > 1 {
        let middle = u32::midpoint(below, above);
        let linear = middle as f64 / (1_u32 << bits) as f64;
        let fifth = linear * linear * linear * linear * linear;
        let reaches = if value <= 12.92 * 0.003_130_8 { 12.92 * linear >= value } else { fifth >= twelfth };
        if reaches {
            above = middle;
        } else {
            below = middle;
        }
    }
    above
}

/// How many thresholds a linear value reaches, by halving the codes that are left: as many comparisons as the code has
/// bits, whatever the value.
#[cfg(feature = "fixed")]
macro_rules! code {
    ($thresholds:expr, $linear:expr) => {{
        let (thresholds, linear) = ($thresholds, $linear);
        let (mut code, mut step) = (0, thresholds.len().div_ceil(2));
        while step > 0 {
            // Always there, which the compiler cannot know: an index would leave it a way to panic.
            let reaches = thresholds.get(code + step - 1).is_some_and(|threshold| linear >= *threshold);
            code += if reaches { step } else { 0 };
            step /= 2;
        }
        code as u8
    }};
}

/// The nearest code of a value in steps of 2^-14.
#[cfg(feature = "fixed")]
#[inline]
pub(crate) fn srgb16<const LAST: usize>(linear: i16) -> u8 {
    code!(&Thresholds::<LAST>::SIXTEEN, linear.max(0).cast_unsigned())
}

/// The nearest code of a value in steps of 2^-30.
#[cfg(feature = "fixed")]
#[inline]
pub(crate) fn srgb32<const LAST: usize>(linear: i32) -> u8 {
    code!(&Thresholds::<LAST>::THIRTY_TWO, linear.max(0).cast_unsigned())
}
