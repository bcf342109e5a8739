//! Exposure: how much light makes full scale.

use crate::{
    color::Rgb,
    error::{Error, Parameter, check_between},
    number::Scalar,
};

/// A factor on all light before it is fitted to the display.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Exposure {
    factor: f32,
}

impl Exposure {
    /// Multiplies all light by a factor.
    ///
    /// # Errors
    /// A factor outside 0 to 1e9.
    pub fn factor(factor: f32) -> Result<Self, Error> {
        check_between(Parameter::Exposure, factor, 0.0, 1e9)?;
        Ok(Self { factor })
    }

    /// Opens by a number of stops: each doubles the light, and each below zero halves it.
    ///
    /// ```
    /// use luminaire::{Rgb, display::Exposure};
    /// let light = Exposure::stops(-2)?.compile::<f32>().expose(Rgb::new(4.0, 2.0, 1.0));
    /// assert_eq!(light, Rgb::new(1.0, 0.5, 0.25));
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    ///
    /// # Errors
    /// More than 24 stops either way.
    pub fn stops(stops: i32) -> Result<Self, Error> {
        check_between(Parameter::Exposure, stops as f32, -24.0, 24.0)?;
        // A power of two is its exponent, moved to where f32 keeps it.
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
    /// The exposure of this gain, as [`codegen`](crate::codegen) writes it.
    pub const fn from_parts(gain: S::Gain) -> Self {
        Self { gain }
    }

    /// The light as it is exposed; a factor of one changes no bit. From light of up to four times full scale a
    /// darker one is within two steps of the format.
    #[inline]
    pub fn expose(&self, light: Rgb<S::Irradiance>) -> Rgb<S::Irradiance> {
        light.map(|channel| S::amplify(channel, self.gain))
    }
}
