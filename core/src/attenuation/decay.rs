//! A real power of the distance.

use super::{Attenuation, Describe};
use crate::{
    effect::{Effect, Effects},
    error::{Error, Expected, Parameter},
    number::{BRIGHTEST, InversePower, Offset, Ray, Scalar},
    source::named,
    stored::stored,
};

/// `d^-k` with a real exponent `k` in (0, 16], capped at a largest factor: the decay of three.js and
/// Godot.
///
/// The power is evaluated in integers, by a logarithm and an exponential from tables. For an
/// exponent of 2 [`InverseSquare`](super::InverseSquare) costs less.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Decay {
    exponent: f32,
    most: f32,
}

stored!(Decay { exponent: f32, most: f32 } by Self::new(exponent, most));

named!(Decay);

/// The largest exponent.
pub(crate) const STEEPEST: f32 = 16.0;

impl Decay {
    /// Creates the attenuation `min(d^-exponent, most)`, for distances in scene units.
    ///
    /// # Errors
    /// An exponent outside (0, 16], or a cap outside 1 to 2^64.
    pub fn new(exponent: f32, most: f32) -> Result<Self, Error> {
        let (parameter, value, accepted) = if !(exponent > 0.0 && exponent <= STEEPEST) {
            (Parameter::Decay, exponent, Expected::UpTo(STEEPEST))
        } else if !(1.0..=BRIGHTEST).contains(&most) {
            (Parameter::Attenuation, most, Expected::Between(1.0, BRIGHTEST))
        } else {
            return Ok(Self { exponent, most });
        };
        Err(Error { parameter, value, accepted })
    }

    /// Returns the exponent `k`.
    pub fn exponent(&self) -> f32 {
        self.exponent
    }

    /// Returns the largest factor.
    pub fn most(&self) -> f32 {
        self.most
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

    fn describe(&self, to: &mut dyn Describe) {
        to.law("Decay", "decay", &[("exponent", &[self.exponent]), ("most", &[self.most])]);
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
