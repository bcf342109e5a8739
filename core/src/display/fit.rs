//! Two policies that map light above full scale. Use the same policy for a whole picture.
//!
//! [`clip`] clips each channel at full scale. Clipping is the cheaper policy, and displays clip by
//! themselves. With `clip` a bright orange turns yellow and then white.
//!
//! [`compress_keep_hue`] divides all channels by the largest channel if the largest exceeds full
//! scale. Orange then stays orange at any brightness that the format holds: in `Fx16` a channel of
//! the sum of all lights saturates at 2^18. This policy costs a reciprocal, and
//! overexposed surfaces do not become brighter with more light.

use crate::{
    color::Rgb,
    number::{Gain, Irradiance, Lights},
};

/// Clips each channel to full scale.
///
/// ```
/// use luminaire::{Rgb, display::clip};
/// assert_eq!(clip(Rgb::new(4.0, 2.0, 0.5)), Rgb::new(1.0, 1.0, 0.5));
/// ```
#[inline]
pub fn clip<I: Irradiance>(light: Rgb<I>) -> Rgb<I::Scalar> {
    light.map(I::Scalar::clip)
}

/// Scales the channels in proportion, so that the largest is at most full scale.
///
/// Light within full scale is unchanged to the bit. For other light, the error against the exact
/// quotient is at most one step of the format in f32, two steps in `Fx16` and eight steps in
/// `Fx32`.
///
/// ```
/// use luminaire::{Rgb, display::compress_keep_hue};
/// assert_eq!(compress_keep_hue(Rgb::new(4.0, 2.0, 0.5)), Rgb::new(1.0, 0.5, 0.125));
/// ```
#[inline]
pub fn compress_keep_hue<I: Irradiance>(light: Rgb<I>) -> Rgb<I::Scalar> {
    let brighter = |a: I, b: I| if a > b { a } else { b };
    let brightest = brighter(brighter(light.red, light.green), light.blue);
    let gain = I::Scalar::light_to_gain(brightest).inverse_capped();
    light.map(|channel| I::Scalar::clip(I::Scalar::amplify(channel, gain)))
}
