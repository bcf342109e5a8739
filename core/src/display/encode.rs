//! Codes of eight bits for what applies a curve to them.

use super::{
    curve::{Encoding, Gamma22, Gamma28, Linear, Srgb},
    dither::{dithered, threshold},
    srgb::nearest_code,
};
use crate::number::Scalar;

/// A curve that a display or a driver applies to its codes: [`Linear`], [`Srgb`], [`Gamma22`] or
/// [`Gamma28`].
///
/// The functions apply the inverse, from linear light to codes of eight bits. The trait is sealed. A
/// table is only linked for a curve that is used.
///
/// ```
/// use luminaire::{Fx16, display::{Curve, Gamma22, Gamma28, Linear, Srgb}};
/// let light = Fx16::from_f32(0.2);
/// assert_eq!([Linear::encode(light), Srgb::encode(light)], [51, 124]);
/// assert_eq!([Gamma22::encode(light), Gamma28::encode(light)], [123, 144]);
/// ```
pub trait Curve: Encoding + Sized {
    /// Returns the code nearest to linear light among the encoded values, as
    /// [`encode_srgb`](super::encode_srgb) does for sRGB.
    ///
    /// The code is 0 for light up to 0 and NaN, and 255 for light from 1 on. The result is exactly
    /// the nearest code, for every value of every format; a tie of the linear curve is rounded up.
    #[inline]
    fn encode<S: Scalar>(light: S) -> u8 {
        nearest_code::<S, Self, 255>(light)
    }

    /// Returns the code for the pixel at `(x, y)`, with ordered dither, as
    /// [`encode_srgb_dithered`](super::encode_srgb_dithered) does for sRGB.
    ///
    /// Over a cell of 8 x 8 pixels the mean light of the codes equals the light, within 1/128 of the
    /// step from one code's light to the next and 2^-23 of full scale: a light is truncated to 2^-24, and the light of
    /// two codes is rounded to it.
    #[inline]
    fn encode_dithered<S: Scalar>(light: S, x: u32, y: u32) -> u8 {
        dithered::<S, Self, 255>(light, threshold(x, y))
    }
}

impl Curve for Linear {}
impl Curve for Srgb {}
impl Curve for Gamma22 {}
impl Curve for Gamma28 {}
