//! One over a polynomial of the distance.

use super::Attenuation;
use crate::{
    effect::{Effect, Effects},
    error::{Error, Parameter},
    model::{Model as _, Number, model},
    number::{Offset, Ray, Scalar},
};

model! {
    /// `1 / (a0 + a1 d + a2 d^2)`, capped at 1: never more than the intensity.
    law Polynomial {
        /// Returns the coefficient `a0`.
        constant: f32 = coefficient(1.0);
        /// Returns the coefficient `a1`, per scene unit.
        linear: f32 = coefficient(0.2).of_dimension(-1);
        /// Returns the coefficient `a2`, per square scene unit.
        quadratic: f32 = coefficient(0.03).of_dimension(-2);
    } by Self::new(constant, linear, quadratic)
}

const fn coefficient(sample: f32) -> Number {
    Number::between(Parameter::Attenuation, 0.0, 1e9, sample).usually(0.0, 4.0)
}

impl Polynomial {
    /// Creates the polynomial with a constant, a linear and a quadratic coefficient, for distances
    /// in scene units. If all three coefficients are 0, the attenuation factor is capped at 1
    /// everywhere.
    ///
    /// # Errors
    /// A coefficient outside 0 to 1e9.
    pub fn new(constant: f32, linear: f32, quadratic: f32) -> Result<Self, Error> {
        for (number, value) in Self::NUMBERS.iter().zip([constant, linear, quadratic]) {
            number.checked(value)?;
        }
        Ok(Self { constant, linear, quadratic })
    }

    /// Returns the constant, the linear and the quadratic coefficient.
    pub fn coefficients(&self) -> [f32; 3] {
        [self.constant, self.linear, self.quadratic]
    }
}

impl Attenuation for Polynomial {
    type Constants<S: Scalar> = [S::Gain; 3];

    fn constants<S: Scalar>(self) -> [S::Gain; 3] {
        self.coefficients().map(S::gain)
    }

    fn effects(&self) -> Effects {
        Effects::NONE.with(Effect::Polynomial)
    }

    fn exact(&self, d: f64) -> f64 {
        let [constant, linear, quadratic] = self.coefficients().map(f64::from);
        1.0 / (constant + linear * d + quadratic * d * d).max(1.0)
    }

    fn growth(&self) -> f32 {
        0.0
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
