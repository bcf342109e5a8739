//! One over a polynomial of the distance.

use super::{Attenuation, Describe};
use crate::{
    effect::{Effect, Effects},
    error::{Error, Parameter, check_between},
    number::{Offset, Ray, Scalar},
    source::named,
    stored::stored,
};

/// `1 / (a0 + a1 d + a2 d^2)`, capped at 1: never more than the intensity.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Polynomial {
    coefficients: [f32; 3],
}

stored!(Polynomial { coefficients: [f32; 3] } by {
    let [constant, linear, quadratic] = coefficients;
    Self::new(constant, linear, quadratic)
});

named!(Polynomial);

impl Polynomial {
    /// Creates the polynomial with a constant, a linear and a quadratic coefficient, for distances
    /// in scene units. If all three coefficients are 0, the attenuation factor is capped at 1
    /// everywhere.
    ///
    /// # Errors
    /// A coefficient outside 0 to 1e9.
    pub fn new(constant: f32, linear: f32, quadratic: f32) -> Result<Self, Error> {
        let coefficients = [constant, linear, quadratic];
        for value in coefficients {
            check_between(Parameter::Attenuation, value, 0.0, 1e9)?;
        }
        Ok(Self { coefficients })
    }

    /// Returns the constant, the linear and the quadratic coefficient.
    pub fn coefficients(&self) -> [f32; 3] {
        self.coefficients
    }
}

impl Attenuation for Polynomial {
    type Constants<S: Scalar> = [S::Gain; 3];

    fn constants<S: Scalar>(self) -> [S::Gain; 3] {
        self.coefficients.map(S::gain)
    }

    fn effects(&self) -> Effects {
        Effects::NONE.with(Effect::Polynomial)
    }

    fn exact(&self, d: f64) -> f64 {
        let [constant, linear, quadratic] = self.coefficients.map(f64::from);
        1.0 / (constant + linear * d + quadratic * d * d).max(1.0)
    }

    fn growth(&self) -> f32 {
        0.0
    }

    fn describe(&self, to: &mut dyn Describe) {
        to.law("Polynomial", "polynomial", &[("coefficients", &self.coefficients)]);
    }

    #[inline]
    fn is_beyond<S: Scalar, O: Offset<S>>(_: &Self::Constants<S>, _: &O) -> bool {
        false
    }

    #[inline(always)] // `lit-polynomial` on Cortex-M0: +174 instructions without.
    fn light<S: Scalar, O: Offset<S>, R: Ray<S>>(
        coefficients: &[S::Gain; 3],
        _: &O,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        ray.light_by_polynomial(share, coefficients, intensity)
    }
}
