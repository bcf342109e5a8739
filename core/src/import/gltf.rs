//! Lights of glTF.

use super::{Distance, Imported, fall::Fall, ramp, spot};
use crate::{
    angle::{Angle, HalfAngle},
    attenuation::Windowed,
    error::{Error, Parameter, check_between, check_up_to},
    light::Spot,
    profile::{Matched, Soft},
    vec3::Vec3,
};

/// A spotlight of glTF's extension `KHR_lights_punctual`, with its defaults.
///
/// The square of the ramp between the cosines of the two angles, and `(1 - (d / range)^4) / d^2`, at least 0:
/// the code that the extension recommends, without its `max(0.001, ...)`, which leaves a beam of one degree
/// dark on its axis. Exact. A node's direction is its local -z.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Gltf {
    /// `innerConeAngle`: the half angle in radians where the light begins to fall, from 0 to the outer one.
    /// At the outer one, which the extension does not allow, it is a step.
    pub inner_cone_angle: f32,
    /// `outerConeAngle`: the half angle in radians where the light ends, more than 0 and at most pi / 2.
    pub outer_cone_angle: f32,
    /// `range`: from 0.001 to 1e9, if there is one.
    pub range: Option<f32>,
    /// `intensity`: in candela, from 0 to 1e9. One candela lights a facing surface at distance 1 to full
    /// scale.
    pub intensity: f32,
}

impl Default for Gltf {
    fn default() -> Self {
        Self {
            inner_cone_angle: 0.0,
            outer_cone_angle: core::f32::consts::FRAC_PI_4,
            range: None,
            intensity: 1.0,
        }
    }
}

impl Gltf {
    /// The spotlight at a position, pointing in a direction.
    ///
    /// # Errors
    /// A parameter out of its range; a position or direction that [`Spot::new`] refuses.
    pub fn import(
        &self,
        position: Vec3<f32>,
        direction: Vec3<f32>,
    ) -> Result<Imported<Spot<Matched, Distance>>, Error> {
        check_up_to(Parameter::OuterConeAngle, self.outer_cone_angle, core::f32::consts::FRAC_PI_2)?;
        check_between(Parameter::InnerConeAngle, self.inner_cone_angle, 0.0, self.outer_cone_angle)?;
        let half = |radians| Angle::from(HalfAngle::radians(radians));
        let cone = ramp(Matched::Soft(Soft), half(self.inner_cone_angle), half(self.outer_cone_angle))?;
        let distance = Distance::Windowed(Windowed::new(self.range)?);
        spot(position, direction, cone, 0.0, Fall { distance, intensity: self.intensity, difference: 0.0 })
    }
}
