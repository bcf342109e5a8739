//! Lights of OpenGL's fixed-function pipeline.

use super::{AnyAttenuation, Difference, Imported, fall, spot};
use crate::{
    angle::{Angle, HalfAngle},
    cone::Cone,
    error::{Error, Expected, Parameter, check_between},
    falloff::AnyFalloff,
    light::{PointLight, SpotLight},
    vec3::Vec3,
};

/// A light of OpenGL 2.1 (specification, section 2.14.1; reference page of `glLight`), with
/// OpenGL's defaults.
///
/// The intensity at an angle a off the direction is `cos(a)^e`, and 0 for an angle over the cutoff.
/// At a distance d the intensity is divided by `k0 + k1 d + k2 d^2`. As in OpenGL, the quotient is
/// not capped, except at distances below 0.001 if `k0` is 0.
///
/// The import is exact. An exponent of 0 gives a cone of constant intensity; a cutoff of 180
/// degrees gives a point light.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct OpenGl {
    /// `GL_SPOT_CUTOFF`: the half angle from which on there is no light. In degrees, in (0, 90];
    /// 180 means a point light.
    pub spot_cutoff: f32,
    /// `GL_SPOT_EXPONENT`: from 0 to 1,024; OpenGL allows up to 128.
    pub spot_exponent: f32,
    /// `GL_CONSTANT_ATTENUATION`: from 0 to 1e9.
    pub constant_attenuation: f32,
    /// `GL_LINEAR_ATTENUATION`: from 0 to 1e9.
    pub linear_attenuation: f32,
    /// `GL_QUADRATIC_ATTENUATION`: from 0 to 1e9.
    pub quadratic_attenuation: f32,
    /// The factor on the colour of the light: from 0 to 1e9.
    pub intensity: f32,
}

/// An imported light: a spotlight or a point light.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum OpenGlLight {
    /// A spotlight.
    Spot(SpotLight<AnyFalloff, AnyAttenuation>),
    /// A point light.
    Point(PointLight<AnyAttenuation>),
}

impl Default for OpenGl {
    fn default() -> Self {
        Self {
            spot_cutoff: 180.0,
            spot_exponent: 0.0,
            constant_attenuation: 1.0,
            linear_attenuation: 0.0,
            quadratic_attenuation: 0.0,
            intensity: 1.0,
        }
    }
}

impl OpenGl {
    /// Returns the light at a position. The direction, `GL_SPOT_DIRECTION`, is used only by a
    /// spotlight.
    ///
    /// # Errors
    /// A parameter out of its range, or no attenuation coefficient of at least 1e-6; a position or
    /// direction that [`SpotLight::new`] rejects; an intensity over 1e9 after division by the
    /// constant coefficient.
    pub fn import(&self, position: Vec3<f32>, direction: Vec3<f32>) -> Result<Imported<OpenGlLight>, Error> {
        check_between(Parameter::SpotExponent, self.spot_exponent, 0.0, 1_024.0)?;
        let coefficients = [self.constant_attenuation, self.linear_attenuation, self.quadratic_attenuation];
        let fall = fall::polynomial(coefficients, None, self.intensity)?;
        if self.spot_cutoff == 180.0 {
            let light = PointLight::new(position)?.with_intensity(fall.intensity)?;
            let light = OpenGlLight::Point(light.with_attenuation(fall.distance));
            return Ok(Imported { light, difference: Difference::NONE });
        }
        // For an exponent below 1, the derivative of `cos^e` with respect to the angle is infinite
        // at 90 degrees. Only a cutoff of 90 degrees includes that angle.
        let is_boundless = self.spot_cutoff == 90.0 && self.spot_exponent > 0.0 && self.spot_exponent < 1.0;
        let difference = if is_boundless { Difference::AT_THE_EDGE } else { Difference::NONE };
        let Imported { light, difference } = spot(position, direction, self.cone()?, difference, fall)?;
        Ok(Imported { light: OpenGlLight::Spot(light), difference })
    }

    fn cone(&self) -> Result<Cone<AnyFalloff>, Error> {
        if !(self.spot_cutoff > 0.0 && self.spot_cutoff <= 90.0) {
            let accepted = Expected::UpToOr(90.0, 180.0);
            return Err(Error { parameter: Parameter::SpotCutoff, value: self.spot_cutoff, accepted });
        }
        let cutoff = Angle::from(HalfAngle::degrees(self.spot_cutoff));
        match AnyFalloff::real_power(self.spot_exponent) {
            step @ AnyFalloff::Step(_) => Cone::from_outer(step, cutoff),
            falloff => Cone::from_outer(falloff, Angle::degrees(180.0))?.with_cutoff(cutoff),
        }
    }
}
