//! Where lights add past full scale: two policies, each stated. Choose once, and choose the same for a whole picture.
//!
//! [`clip`] cuts each channel at full scale. It is the cheaper one and what displays do by themselves; a bright orange
//! turns to yellow and then to white.
//!
//! [`compress_keep_hue`] divides all channels by the largest where that is over full scale. Orange stays orange
//! however bright, at the price of a reciprocal, and of surfaces that no longer grow brighter.

use crate::{
    color::Rgb,
    number::{Gain, Scalar},
};

/// Each channel clipped to full scale.
///
/// ```
/// use luminaire::{Rgb, display::clip};
/// assert_eq!(clip::<f32>(Rgb::new(4.0, 2.0, 0.5)), Rgb::new(1.0, 1.0, 0.5));
/// ```
#[inline]
pub fn clip<S: Scalar>(light: Rgb<S::Irradiance>) -> Rgb<S> {
    light.map(S::clip)
}

/// The channels in their proportion, the largest at full scale if it was over it. Light that fits is unchanged to the bit;
/// elsewhere each channel is within two steps of the format of the exact quotient, one in f32, eight in `Fx32`.
///
/// ```
/// use luminaire::{Rgb, display::compress_keep_hue};
/// assert_eq!(compress_keep_hue::<f32>(Rgb::new(4.0, 2.0, 0.5)), Rgb::new(1.0, 0.5, 0.125));
/// ```
#[inline]
pub fn compress_keep_hue<S: Scalar>(light: Rgb<S::Irradiance>) -> Rgb<S> {
    let brighter = |a: S::Irradiance, b: S::Irradiance| if a > b { a } else { b };
    let brightest = brighter(brighter(light.red, light.green), light.blue);
    let gain = S::light_to_gain(brightest).inverse_capped();
    light.map(|channel| S::clip(S::amplify(channel, gain)))
}
