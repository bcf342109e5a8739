//! Spotlights with an umbra and a penumbra.

use super::{AnyAttenuation, Difference, Imported, fall::Fall, ramp, spot};
use crate::{
    angle::Angle,
    attenuation::{CutAt, InverseSquare},
    error::{Error, Expected, Parameter},
    falloff::{AnyFalloff, Linear, Smooth},
    light::SpotLight,
    vec3::Vec3,
};

/// A spotlight with full intensity within its umbra and none outside its penumbra.
///
/// The retained mode of early Direct3D and many small engines have this spotlight. The attenuation
/// is the inverse-square law; [`SpotLight::with_attenuation`] changes the attenuation. The import
/// is exact.
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
    /// The full angle up to which the intensity is full, from 0 to the penumbra.
    /// [`HalfAngle`](crate::HalfAngle) converts the half angles of other engines.
    pub umbra: Angle,
    /// The full angle from which on there is no light, in (0, 180] degrees. A penumbra equal to the
    /// umbra gives a step.
    pub penumbra: Angle,
    /// The falloff between the umbra and the penumbra.
    pub ramp: Ramp,
    /// The intensity at distance 1: from 0 to 1e9.
    pub intensity: f32,
}

/// The falloff as a function of the cosine, from the umbra to the edge of the penumbra.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ramp {
    /// Linear in the cosine.
    Linear,
    /// Smoothstep.
    Smooth,
}

impl Penumbra {
    /// Returns the spotlight at a position, pointing in a direction.
    ///
    /// # Errors
    /// A parameter out of its range; a position or direction that [`SpotLight::new`] rejects.
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
        let falloff = match self.ramp {
            Ramp::Linear => AnyFalloff::Linear(Linear),
            Ramp::Smooth => AnyFalloff::Smooth(Smooth),
        };
        let cone = ramp(falloff, self.umbra, self.penumbra)?;
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
