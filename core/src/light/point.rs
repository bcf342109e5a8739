//! Light from a place into all directions.

use super::{Emission, check_reach, checked_position};
use crate::{
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    error::{Error, Parameter},
    number::Scalar,
    shade::CompiledPointLight,
    vec3::Vec3,
};

/// The solid angle of all directions, in steradians.
const SPHERE: f32 = 2.0 * core::f32::consts::TAU;

/// A point light: it shines from a position into all directions alike.
///
/// ```
/// use luminaire::{PointLight, Vec3, attenuation::{GltfRange, InverseSquare}};
/// let bulb = PointLight::new(Vec3::new(0.0, 2.0, 0.0))?.with_intensity(4.0)?;
/// let (floor, up) = (Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
/// assert_eq!(bulb.compile::<f32>()?.irradiance(floor, up), 1.0);
/// let short = bulb.with_attenuation(GltfRange::new(InverseSquare, Some(1.5))?);
/// assert_eq!(short.compile::<f32>()?.irradiance(floor, up), 0.0);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PointLight<A = InverseSquare> {
    position: Vec3<f32>,
    attenuation: A,
    emission: Emission,
}

impl PointLight {
    /// A white point light of intensity 1 that falls with the square of the distance.
    ///
    /// # Errors
    /// A position that is not finite.
    pub fn new(position: impl Into<Vec3<f32>>) -> Result<Self, Error> {
        let position = position.into();
        let position = checked_position(Parameter::Position, position)?;
        Ok(Self { position, attenuation: InverseSquare, emission: Emission::WHITE })
    }
}

impl<A: Attenuation> PointLight<A> {
    /// The same light in this linear colour, its highlights included.
    ///
    /// # Errors
    /// A channel outside [0, 1]: brightness is the intensity's part.
    pub fn with_color(self, color: Rgb<f32>) -> Result<Self, Error> {
        Ok(Self { emission: self.emission.with_color(color)?, ..self })
    }

    /// The same light with highlights in this linear colour.
    ///
    /// # Errors
    /// A channel outside [0, 1].
    pub fn with_specular_color(self, color: Rgb<f32>) -> Result<Self, Error> {
        Ok(Self { emission: self.emission.with_specular_color(color)?, ..self })
    }

    /// The same light with this intensity: with 1, a surface that faces the light gets full scale, at distance 1 if there
    /// is attenuation.
    ///
    /// # Errors
    /// A negative intensity, or one over 1e9.
    pub fn with_intensity(self, intensity: f32) -> Result<Self, Error> {
        Ok(Self { emission: self.emission.with_intensity(intensity)?, ..self })
    }

    /// The linear colour.
    pub fn color(&self) -> Rgb<f32> {
        self.emission.color
    }

    /// The linear colour of the highlights.
    pub fn specular_color(&self) -> Rgb<f32> {
        self.emission.specular_color
    }

    /// The intensity.
    pub fn intensity(&self) -> f32 {
        self.emission.intensity
    }

    /// The same light with another distance model.
    pub fn with_attenuation<B: Attenuation>(&self, attenuation: B) -> PointLight<B> {
        PointLight { position: self.position, attenuation, emission: self.emission }
    }

    /// Where the light stands.
    pub fn position(&self) -> Vec3<f32> {
        self.position
    }

    /// The distance model.
    pub fn attenuation(&self) -> A {
        self.attenuation
    }

    /// The luminous flux in lumens of this light with an intensity in candela: `4 pi` times it, the
    /// intensity of all directions alike.
    pub fn lumens(&self, candela: f32) -> f32 {
        candela * SPHERE
    }

    /// The intensity in candela of this light when its flux is in lumens: the inverse of
    /// [`lumens`](Self::lumens). Of a flux of 1 arrives `1 / (4 pi d^2)` at a facing surface at
    /// distance d.
    pub fn candela(&self, lumens: f32) -> f32 {
        lumens / SPHERE
    }

    /// Compiles the light for the format `S`.
    ///
    /// # Errors
    /// A position beyond [`Scalar::FARTHEST`].
    pub fn compile<S: Scalar>(&self) -> Result<CompiledPointLight<S, A>, Error> {
        check_reach::<S>(self.position)?;
        Ok(CompiledPointLight {
            position: self.position.map(S::length),
            attenuation: self.attenuation.constants::<S>(),
            intensity: S::gain(self.emission.intensity),
            fine_below: S::fine_below(0.0, self.emission.intensity, self.attenuation.grows()),
            color: self.emission.color.map(S::from_f32),
            specular_color: self.emission.specular_color.map(S::from_f32),
        })
    }
}
