//! Directional lights.

use super::{Axis, Emission};
use crate::{
    color::Rgb,
    error::{Error, Parameter},
    number::Scalar,
    shade::CompiledDirectionalLight,
    stored::stored,
    vec3::Vec3,
};

/// A directional light: the same direction and intensity everywhere, like sunlight.
///
/// ```
/// use luminaire::{DirectionalLight, Vec3};
/// let sun = DirectionalLight::new(Vec3::new(0.0, -1.0, 0.0))?.with_intensity(0.75)?;
/// assert_eq!(sun.compile::<f32>().irradiance(Vec3::new(0.0, 1.0, 0.0)), 0.75);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DirectionalLight {
    direction: Axis,
    emission: Emission,
}

stored!(DirectionalLight { direction: Axis, emission: Emission } by Ok::<_, Error>(Self { direction, emission }));

impl DirectionalLight {
    /// Creates a white light of intensity 1 that travels in this direction, which need not have
    /// unit length.
    ///
    /// # Errors
    /// A direction that is zero or not finite, or whose length cannot be squared in f32.
    pub fn new(direction: impl Into<Vec3<f32>>) -> Result<Self, Error> {
        let (direction, _) = Axis::new(Parameter::Direction, direction.into())?;
        Ok(Self { direction, emission: Emission::WHITE })
    }
}

emits!(DirectionalLight, "light to full scale.");

impl DirectionalLight {
    /// Returns the direction in which the light travels, of unit length.
    pub fn direction(&self) -> Vec3<f32> {
        self.direction.unit
    }

    /// Returns the direction as it was given, without a rounding error, at another length: its
    /// largest component is in [1/2, 1]. A light with this direction compiles to the same bits.
    pub fn given_direction(&self) -> Vec3<f32> {
        self.direction.toward
    }

    /// Compiles the light for the format `S`.
    pub fn compile<S: Scalar>(&self) -> CompiledDirectionalLight<S> {
        CompiledDirectionalLight {
            direction: S::aim(self.direction.toward, self.direction.unit),
            intensity: S::gain(self.emission.intensity),
            color: self.emission.color.map(S::from_f32),
            specular_color: self.emission.specular_color.map(S::from_f32),
        }
    }
}
