//! Exposure: a factor on all light. The factor determines how much light maps to full scale.

use crate::{
    color::Rgb,
    error::{Error, Parameter, check_between},
    number::Scalar,
};

/// A factor applied to all light before it is mapped to the display.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Exposure {
    factor: f32,
}

impl Exposure {
    /// Creates an exposure that multiplies all light by a factor.
    ///
    /// # Errors
    /// A factor outside 0 to 1e9.
    pub fn factor(factor: f32) -> Result<Self, Error> {
        check_between(Parameter::Exposure, factor, 0.0, 1e9)?;
        Ok(Self { factor })
    }

    /// Creates an exposure from a number of stops: the factor is `2^stops`.
    ///
    /// ```
    /// use luminaire::{Rgb, display::Exposure};
    /// let light = Exposure::stops(-2)?.compile::<f32>().expose(Rgb::new(4.0, 2.0, 1.0));
    /// assert_eq!(light, Rgb::new(1.0, 0.5, 0.25));
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    ///
    /// # Errors
    /// A number of stops outside -24 to 24.
    pub fn stops(stops: i32) -> Result<Self, Error> {
        check_between(Parameter::Exposure, stops as f32, -24.0, 24.0)?;
        // Writes the exponent of the power of two into the bits of an f32.
        Ok(Self { factor: f32::from_bits(((127 + stops) as u32) << 23) })
    }

    /// Compiles the exposure for the format `S`.
    pub fn compile<S: Scalar>(self) -> CompiledExposure<S> {
        CompiledExposure { gain: S::gain(self.factor) }
    }
}

/// An exposure compiled for the format `S`. Made by [`Exposure::compile`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledExposure<S: Scalar> {
    pub(crate) gain: S::Gain,
}

impl<S: Scalar> CompiledExposure<S> {
    /// Creates an exposure from its gain, as [`codegen`](crate::codegen) writes it.
    pub const fn from_parts(gain: S::Gain) -> Self {
        Self { gain }
    }

    /// Returns the light times the factor; a factor of 1 changes no bit.
    ///
    /// For light of up to four times full scale and a factor below 1, the error is at most two
    /// steps of the format.
    #[inline]
    pub fn expose(&self, light: Rgb<S::Irradiance>) -> Rgb<S::Irradiance> {
        light.map(|channel| S::amplify(channel, self.gain))
    }
}
