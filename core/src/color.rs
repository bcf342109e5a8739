//! Linear colour, and its encoding for a display without a power function.

use crate::{scalar::float::clamp, trig};

/// Red, green and blue.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Rgb<T> {
    /// The red channel.
    pub red: T,
    /// The green channel.
    pub green: T,
    /// The blue channel.
    pub blue: T,
}

impl<T> Rgb<T> {
    /// The colour of these channels.
    pub const fn new(red: T, green: T, blue: T) -> Self {
        Self { red, green, blue }
    }

    /// Applies `f` to each channel.
    #[inline(always)]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Rgb<U> {
        Rgb::new(f(self.red), f(self.green), f(self.blue))
    }
}

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
/// Two square roots and a polynomial in place of the power 1/2.4 (IEC 61966-2-1). Before it is rounded the code is
/// within 0.002 of the exact one (searched), so that at most one value in 250 rounds the other way.
///
/// ```
/// assert_eq!([0.0, 0.5, 1.0].map(luminaire::encode_srgb), [0, 188, 255]);
/// ```
#[inline(always)]
pub fn encode_srgb(linear: f32) -> u8 {
    let linear = clamp(linear);
    let curve = polynomial(ENCODE, trig::sqrt(trig::sqrt(linear)));
    let code = if linear < TOE { 255.0 * 12.92 * linear } else { curve };
    (code + 0.5) as i32 as u8
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
