//! The linear value of an sRGB code (IEC 61966-2-1), in the arithmetic of each format.

use super::{
    dither::srgb_light,
    srgb::{TOE, polynomial},
};
use crate::number::{Scalar, float::clamp};

/// The sRGB decoding `((v + 0.055) / 1.055)^2.4` for `v` in `[0, 1]`: minimax fit of degree 7.
///
/// Coefficients start with the constant term.
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

/// Returns the linear value of an sRGB code, in `[0, 1]`: of a colour, or of a texture's channel.
///
/// It is within 2e-6 in `f32`, which evaluates a polynomial. Fixed point reads the table of the dither: the value is
/// the nearest one of `Fx16`, and within 2^-25 in `Fx32` (exhaustive). [`encode_srgb`](super::encode_srgb) of the result returns the code.
///
/// A surface with a texture reflects the light that arrives times the linear values of its texel, as
/// [`filtered`](crate::Rgb::filtered) has it:
///
/// ```
/// use luminaire::{Fx16, Rgb, display::{Rgb565, clip, decode_srgb}, number::Light16};
/// let texel = Rgb565::from_codes(Rgb::new(255, 188, 0));
/// let light = Rgb::new(Light16::ONE, Light16::ONE, Light16::ONE);
/// let reflected = clip(light.filtered(texel.to_codes().map(decode_srgb::<Fx16>)));
/// assert_eq!(Rgb565::from_linear(reflected), texel);
/// ```
#[inline]
pub fn decode_srgb<S: Scalar>(code: u8) -> S {
    S::of_linear(|| decode(f32::from(code) / 255.0), || srgb_light(code))
}

/// Returns the linear value of an encoded value in `[0, 1]`, within 2e-6.
pub(crate) fn decode(value: f32) -> f32 {
    if value <= 12.92 * TOE { value / 12.92 } else { clamp(polynomial(DECODE, value)) }
}
