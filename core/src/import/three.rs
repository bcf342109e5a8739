//! Lights of three.js.

use super::{AnyAttenuation, Difference, Imported, fall, ramp, spot};
use crate::{
    angle::{Angle, HalfAngle},
    error::{Error, Parameter, check_between, check_up_to},
    falloff::{AnyFalloff, Smooth, exponent::real_power},
    light::SpotLight,
    vec3::Vec3,
};

/// A `SpotLight` of three.js (its shader chunk `lights_pars_begin` and `WebGLLights`), with its defaults.
///
/// Smoothstep from `cos(angle)` to `cos(angle (1 - penumbra))`, which is exact. It is divided by
/// `max(d^decay, 0.01)`, and in Filament's window `(1 - (d / distance)^4)^2` where there is a distance. The
/// decays 0, 1 and 2 are exact, but that the last of them goes on growing nearer than 0.1, where three.js
/// stops at 100.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Three {
    /// `angle`: the half angle in radians where the light ends, more than 0 and at most pi / 2.
    pub angle: f32,
    /// `penumbra`: the part of the angle over which the light falls, from 0, a step, to 1.
    pub penumbra: f32,
    /// `distance`: where the light ends, from 0.001 to 1e9; 0 where it does not.
    pub distance: f32,
    /// `decay`: the exponent of the fall with distance, from 0 to 16.
    pub decay: f32,
    /// `intensity`: in candela, from 0 to 1e9.
    pub intensity: f32,
}

impl Default for Three {
    fn default() -> Self {
        Self { angle: core::f32::consts::FRAC_PI_3, penumbra: 0.0, distance: 0.0, decay: 2.0, intensity: 1.0 }
    }
}

impl Three {
    /// The spotlight at a position, pointing in a direction: in three.js that from its position to its
    /// target.
    ///
    /// # Errors
    /// A parameter out of its range; a position or direction that [`SpotLight::new`] refuses.
    pub fn import(
        &self,
        position: Vec3<f32>,
        direction: Vec3<f32>,
    ) -> Result<Imported<SpotLight<AnyFalloff, AnyAttenuation>>, Error> {
        check_up_to(Parameter::SpotAngle, self.angle, core::f32::consts::FRAC_PI_2)?;
        check_between(Parameter::Penumbra, self.penumbra, 0.0, 1.0)?;
        let half = |radians| Angle::from(HalfAngle::radians(radians));
        let inner = half(self.angle * (1.0 - self.penumbra));
        let cone = ramp(AnyFalloff::Smooth(Smooth), inner, half(self.angle))?;
        let range = if self.distance == 0.0 { None } else { Some(self.distance) };
        // Where d^decay is 0.01.
        let stop = real_power(0.01, 1.0 / f64::from(self.decay));
        let fall = fall::decay(self.decay, stop, range, self.intensity)?;
        spot(position, direction, cone, Difference::NONE, fall)
    }
}
