//! Lights of Direct3D's fixed-function pipeline.

use super::{AnyAttenuation, Difference, Imported, fall, ramp, spot};
use crate::{
    angle::Angle,
    error::{Error, Parameter, check_between, check_up_to},
    falloff::AnyFalloff,
    light::SpotLight,
    vec3::Vec3,
};

/// A spotlight of Direct3D 9 (`D3DLIGHT9`, and *Attenuation and Spotlight Factor* of its
/// programming guide).
///
/// `rho` is the cosine of the angle off the light's direction. The intensity is full for
/// `rho > cos(theta / 2)`, 0 for `rho <= cos(phi / 2)`, and in between
///
/// ```text
/// ((rho - cos(phi / 2)) / (cos(theta / 2) - cos(phi / 2)))^falloff
/// ```
///
/// At a distance d the intensity is divided by `attenuation0 + attenuation1 d + attenuation2 d^2`;
/// beyond the range the light is 0. The import is exact. With a falloff of 0, or with `theta = phi`, the light is a
/// step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Direct3d {
    /// `Theta`: the full inner angle in radians, from 0 to phi.
    pub theta: f32,
    /// `Phi`: the full outer angle in radians, in (0, pi].
    pub phi: f32,
    /// `Falloff`: the exponent, from 0 to 1,024; 1 in most programs.
    pub falloff: f32,
    /// `Attenuation0`: from 0 to 1e9.
    pub attenuation0: f32,
    /// `Attenuation1`: from 0 to 1e9.
    pub attenuation1: f32,
    /// `Attenuation2`: from 0 to 1e9.
    pub attenuation2: f32,
    /// `Range`: at least 0.001. A value above 1e9, such as Direct3D's maximum `sqrt(FLT_MAX)`,
    /// means no range.
    pub range: f32,
    /// The factor on the colour of the light: from 0 to 1e9.
    pub intensity: f32,
}

impl Direct3d {
    /// Returns the spotlight at a position, pointing in a direction.
    ///
    /// # Errors
    /// A parameter out of its range, or no attenuation coefficient of at least 1e-6; a position or
    /// direction that [`SpotLight::new`] rejects; an intensity over 1e9 after division by the
    /// constant coefficient.
    pub fn import(
        &self,
        position: Vec3<f32>,
        direction: Vec3<f32>,
    ) -> Result<Imported<SpotLight<AnyFalloff, AnyAttenuation>>, Error> {
        check_up_to(Parameter::Phi, self.phi, core::f32::consts::PI)?;
        check_between(Parameter::Theta, self.theta, 0.0, self.phi)?;
        check_between(Parameter::Falloff, self.falloff, 0.0, 1_024.0)?;
        let falloff = AnyFalloff::real_power(self.falloff);
        let (theta, phi) = (Angle::radians(self.theta), Angle::radians(self.phi));
        // A step has no inner angle.
        let is_step = theta >= phi || matches!(falloff, AnyFalloff::Step(_));
        let cone = ramp(falloff, if is_step { phi } else { theta }, phi)?;
        let coefficients = [self.attenuation0, self.attenuation1, self.attenuation2];
        let range = if self.range > 1e9 { None } else { Some(self.range) };
        let fall = fall::polynomial(coefficients, range, self.intensity)?;
        let is_boundless = !is_step && self.falloff < 1.0;
        let difference = if is_boundless { Difference::AT_THE_EDGE } else { Difference::NONE };
        spot(position, direction, cone, difference, fall)
    }
}
