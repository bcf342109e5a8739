//! Spotlights of an umbra and a penumbra.

use super::{AnyAttenuation, Difference, Imported, fall::Fall, ramp, spot};
use crate::{
    angle::Angle,
    attenuation::{CutAt, InverseSquare},
    error::{Error, Expected, Parameter},
    falloff::{AnyFalloff, Linear, Smooth},
    light::SpotLight,
    vec3::Vec3,
};

/// A spotlight that is full within its umbra and ends at its penumbra, as the retained mode of early Direct3D
/// and many a small engine have it. With the inverse-square law, until it is given another [distance
/// model](SpotLight::with_attenuation). Exact.
///
/// ```
/// use luminaire::{Angle, Vec3, import};
/// let umbra = Angle::degrees(20.0);
/// let spot = import::Penumbra { umbra, penumbra: Angle::degrees(30.0), ramp: import::Ramp::Linear, intensity: 4.0 };
/// let light = spot.import(Vec3::default(), Vec3::new(0.0, 0.0, 1.0))?.light;
/// assert!((light.cone().inner().to_degrees() - 20.0).abs() < 1e-4);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Penumbra {
    /// Up to where the light is full: a full angle from 0 to that of the penumbra. Engines that give half
    /// angles are served by [`HalfAngle`](crate::HalfAngle).
    pub umbra: Angle,
    /// Where the light ends: a full angle of more than 0 and at most 180 degrees. At the umbra it is a step.
    pub penumbra: Angle,
    /// How the light falls in between.
    pub ramp: Ramp,
    /// How strong the light is at distance 1: from 0 to 1e9.
    pub intensity: f32,
}

/// How the light falls over the cosine from an umbra to the edge of its penumbra.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ramp {
    /// On a straight line.
    Linear,
    /// By smoothstep.
    Smooth,
}

impl Penumbra {
    /// The spotlight at a position, pointing in a direction.
    ///
    /// # Errors
    /// A parameter out of its range; a position or direction that [`SpotLight::new`] refuses.
    pub fn import(
        &self,
        position: Vec3<f32>,
        direction: Vec3<f32>,
    ) -> Result<Imported<SpotLight<AnyFalloff, AnyAttenuation>>, Error> {
        let none = Angle::degrees(0.0);
        if !(self.penumbra > none && self.penumbra <= Angle::degrees(180.0)) {
            let (value, accepted) = (self.penumbra.to_degrees(), Expected::AngleUpTo(180.0));
            return Err(Error { parameter: Parameter::Penumbra, value, accepted });
        }
        if !(self.umbra >= none && self.umbra <= self.penumbra) {
            let accepted = Expected::AngleBetween(0.0, self.penumbra.to_degrees());
            return Err(Error { parameter: Parameter::Umbra, value: self.umbra.to_degrees(), accepted });
        }
        let profile = match self.ramp {
            Ramp::Linear => AnyFalloff::Linear(Linear),
            Ramp::Smooth => AnyFalloff::Smooth(Smooth),
        };
        let cone = ramp(profile, self.umbra, self.penumbra)?;
        let distance = AnyAttenuation::InverseSquare(CutAt::new(InverseSquare, None)?);
        spot(
            position,
            direction,
            cone,
            Difference::NONE,
            Fall { distance, intensity: self.intensity, difference: 0.0 },
        )
    }
}
