//! A real power of the distance.

use super::Attenuation;
use crate::{
    effect::{Effect, Effects},
    error::{Error, Parameter},
    model::{Model as _, Number, model},
    number::{BRIGHTEST, InversePower, Offset, Ray, Scalar},
};

model! {
    /// `d^-k` with a real exponent `k` in (0, 16], capped at a largest factor: the decay of three.js and
    /// Godot.
    ///
    /// The power is evaluated in integers, by a logarithm and an exponential from tables. For an
    /// exponent of 2 [`InverseSquare`](super::InverseSquare) costs less.
    law Decay {
        /// Returns the exponent `k`.
        exponent: f32 = Number::positive(Parameter::Decay, 0.125, STEEPEST, 1.5).usually(0.125, 8.0);
        /// Returns the largest factor.
        most: f32 = Number::between(Parameter::Attenuation, 1.0, BRIGHTEST, 100.0).usually(1.0, 1_000.0);
    } by Self::new(exponent, most)
}

/// The largest exponent.
const STEEPEST: f32 = 16.0;

impl Decay {
    /// Creates the attenuation `min(d^-exponent, most)`, for distances in scene units.
    ///
    /// # Errors
    /// An exponent outside (0, 16], or a cap outside 1 to 2^64.
    pub fn new(exponent: f32, most: f32) -> Result<Self, Error> {
        let [own, cap] = [Self::NUMBERS[0], Self::NUMBERS[1]];
        Ok(Self { exponent: own.checked(exponent)?, most: cap.checked(most)? })
    }
}

impl Attenuation for Decay {
    /// The same in every format.
    type Constants<S: Scalar> = InversePower;

    fn constants<S: Scalar>(self) -> InversePower {
        InversePower::new(self.exponent, self.most)
    }

    fn effects(&self) -> Effects {
        Effects::NONE.with(Effect::Decay)
    }

    /// Without `libm` the relative error is up to 1e-9.
    fn exact(&self, d: f64) -> f64 {
        #[cfg(feature = "libm")]
        let power = libm::pow(d, self.exponent.into());
        #[cfg(not(feature = "libm"))]
        let power = crate::trig::real_power(d, self.exponent.into());
        (1.0 / power).min(self.most.into())
    }

    fn growth(&self) -> f32 {
        self.exponent
    }

    #[inline]
    fn is_beyond<S: Scalar, O: Offset<S>>(_: &Self::Constants<S>, _: &O) -> bool {
        false
    }

    #[inline]
    fn light<S: Scalar, O: Offset<S>, R: Ray<S>>(
        power: &InversePower,
        _: &O,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        ray.light_by_decay(share, *power, intensity)
    }
}
