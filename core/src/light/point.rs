//! Point lights.

use super::{Emission, check_reach, checked_position, range_above};
use crate::{
    attenuation::{Attenuation, InverseSquare},
    color::Rgb,
    error::{Error, Parameter},
    number::Scalar,
    shade::CompiledPointLight,
    stored::stored,
    vec3::Vec3,
};

/// The solid angle of a sphere, in steradians.
const SPHERE: f32 = 2.0 * core::f32::consts::TAU;

/// A point light: it emits the same intensity in all directions from one position.
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
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PointLight<A = InverseSquare> {
    position: Vec3<f32>,
    attenuation: A,
    emission: Emission,
}

stored!([A: Attenuation] PointLight<A> { position: Vec3<f32>, attenuation: A, emission: Emission }
    by checked_position(Parameter::Position, position)
        .map(|position| Self { position, attenuation, emission }));

impl PointLight {
    /// Creates a white point light of intensity 1 with the inverse-square law.
    ///
    /// # Errors
    /// A position that is not finite.
    pub fn new(position: impl Into<Vec3<f32>>) -> Result<Self, Error> {
        let position = position.into();
        let position = checked_position(Parameter::Position, position)?;
        Ok(Self { position, attenuation: InverseSquare, emission: Emission::WHITE })
    }
}

emits!(PointLight<A>, "light to full scale; with attenuation, this holds at distance 1.", A: Attenuation);

impl<A: Attenuation> PointLight<A> {
    /// Returns the light with another attenuation.
    pub fn with_attenuation<B: Attenuation>(&self, attenuation: B) -> PointLight<B> {
        PointLight { position: self.position, attenuation, emission: self.emission }
    }

    /// Returns the position of the light.
    pub fn position(&self) -> Vec3<f32> {
        self.position
    }

    /// Returns the attenuation.
    pub fn attenuation(&self) -> A {
        self.attenuation
    }

    /// Returns the luminous flux in lumens for an intensity in candela: `4 pi candela`.
    pub fn lumens(&self, candela: f32) -> f32 {
        candela * SPHERE
    }

    /// Returns the intensity in candela for a luminous flux in lumens: the inverse of
    /// [`lumens`](Self::lumens). A flux of 1 lumen gives a surface that faces the light at distance
    /// `d` an illuminance of `1 / (4 pi d^2)`.
    pub fn candela(&self, lumens: f32) -> f32 {
        lumens / SPHERE
    }

    /// Returns the distance from which on a surface that faces the light receives less than
    /// `light`: `sqrt(I / light)` with the inverse square, infinity if the light never falls so low.
    ///
    /// The distance is rounded up. It is that of the exact attenuation, without the error of a number
    /// format. A surface that is farther away than the range above [`Pixel::FIRST_STEP`] shows no
    /// step of this light alone without dither:
    ///
    /// ```
    /// use luminaire::{PointLight, attenuation::SmoothRange, display::{Gray4, Pixel}};
    /// let bulb = PointLight::new([0.0, 2.0, 0.0])?.with_attenuation(SmoothRange::new(10.0)?);
    /// assert!((9.70..9.71).contains(&bulb.range_above(Gray4::FIRST_STEP)));
    /// # Ok::<(), luminaire::Error>(())
    /// ```
    ///
    /// [`Pixel::FIRST_STEP`]: crate::display::Pixel::FIRST_STEP
    pub fn range_above(&self, light: f32) -> f32 {
        range_above(self.attenuation, self.emission.intensity, light)
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
            fine_below: S::fine_below(0.0, self.emission.intensity, self.attenuation.growth()),
            color: self.emission.color.map(S::from_f32),
            specular_color: self.emission.specular_color.map(S::from_f32),
        })
    }
}
