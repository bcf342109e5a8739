//! Smoothstep to a range.

use super::{Attenuation, checked_range, dimmed, inverse_squared, squared_fraction};
use crate::{
    effect::{Effect, Effects},
    error::Error,
    model::{Number, model},
    number::{Offset, Ray, Scalar, Share},
};

model! {
    /// Smoothstep to a range: 1 at distance 0, 0 at the range, with derivative 0 at both ends.
    ///
    /// The dual-cone article writes `smoothstep(range, 0, d)`. In GLSL this expression is undefined,
    /// because its edges are in descending order; `SmoothRange` implements the intended function.
    law SmoothRange {
        /// Returns the range.
        range: f32 = Number::range();
    } by Self::new(range)
}

impl SmoothRange {
    /// Creates the attenuation with this range, in scene units.
    ///
    /// # Errors
    /// A range outside 0.001 to 1e9.
    pub fn new(range: f32) -> Result<Self, Error> {
        Ok(Self { range: checked_range(range)? })
    }
}

impl Attenuation for SmoothRange {
    /// The reciprocals of the range and of its square.
    type Constants<S: Scalar> = [S::Gain; 2];

    fn constants<S: Scalar>(self) -> [S::Gain; 2] {
        [S::gain(1.0 / self.range), inverse_squared::<S>(Some(self.range))]
    }

    fn range(&self) -> Option<f32> {
        Some(self.range)
    }

    fn effects(&self) -> Effects {
        Effects::NONE.with(Effect::SmoothRange).with(Effect::Range)
    }

    fn exact(&self, d: f64) -> f64 {
        let t = (1.0 - d / f64::from(self.range)).max(0.0);
        t * t * (3.0 - 2.0 * t)
    }

    fn growth(&self) -> f32 {
        0.0
    }

    #[inline]
    fn is_beyond<S: Scalar, O: Offset<S>>(&[_, squared]: &[S::Gain; 2], offset: &O) -> bool {
        squared_fraction::<S, O>(squared, offset) == S::ONE
    }

    #[inline(always)] // `lit-smooth-range` on Cortex-M0: +273 instructions without.
    fn light<S: Scalar, O: Offset<S>, R: Ray<S>>(
        constants: &[S::Gain; 2],
        offset: &O,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        let smooth = ray.range_share(constants[0]).complement().smooth();
        let is_beyond = ray.squared_range_share(offset, constants[1]).is_one();
        let smooth = if is_beyond { R::Share::default() } else { smooth };
        dimmed::<S, _>(share, smooth).light(intensity)
    }
}
