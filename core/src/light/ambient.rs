//! Ambient light.

use crate::{
    color::{Rgb, checked_color},
    error::{Error, Parameter, check_between},
    number::Scalar,
    stored::stored,
};

/// A global ambient light: the same at every point and from every direction, `Ia` of the classic
/// lighting equation.
///
/// ```
/// use luminaire::{AmbientLight, Rgb};
/// let night = AmbientLight::new(Rgb::new(0.4, 0.5, 1.0))?.with_intensity(0.02)?;
/// assert_eq!(night.compile::<f32>().blue, 0.02);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct AmbientLight {
    color: Rgb<f32>,
    intensity: f32,
}

stored!(AmbientLight { color: Rgb<f32>, intensity: f32 } by Self::new(color).and_then(|light| light.with_intensity(intensity)));

impl AmbientLight {
    /// Creates ambient light with this linear colour and intensity 1.
    ///
    /// # Errors
    /// A channel outside [0, 1]: brightness belongs in the intensity.
    pub fn new(color: Rgb<f32>) -> Result<Self, Error> {
        Ok(Self { color: checked_color(color)?, intensity: 1.0 })
    }

    /// Returns the light with this intensity: 1 lights a white surface to full scale.
    ///
    /// # Errors
    /// A negative intensity, or one over 1e9.
    pub fn with_intensity(self, intensity: f32) -> Result<Self, Error> {
        check_between(Parameter::Intensity, intensity, 0.0, 1e9)?;
        Ok(Self { intensity, ..self })
    }

    /// Returns the linear colour.
    pub fn color(&self) -> Rgb<f32> {
        self.color
    }

    /// Returns the intensity.
    pub fn intensity(&self) -> f32 {
        self.intensity
    }

    /// Converts the light to the format `S`, for
    /// [`CompiledMaterial::glow`](crate::light::CompiledMaterial::glow).
    pub fn compile<S: Scalar>(&self) -> Rgb<S::Irradiance> {
        self.color.map(|channel| S::ONE.light(S::gain(channel * self.intensity)))
    }
}
