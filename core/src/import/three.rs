//! Lights of three.js.

use super::{AnyAttenuation, Difference, Imported, fall, ramp, spot};
use crate::{
    angle::{Angle, HalfAngle},
    error::{Error, Parameter, check_between, check_up_to},
    falloff::{AnyFalloff, Smooth},
    light::SpotLight,
    trig::real_power,
    vec3::Vec3,
};

/// A `SpotLight` of three.js (its shader chunk `lights_pars_begin` and `WebGLLights`), with its
/// defaults.
///
/// The falloff is smoothstep from `cos(angle)` to `cos(angle (1 - penumbra))`. The import of the
/// falloff is exact. The intensity is divided by `max(d^decay, 0.01)`, with Filament's window
/// `(1 - (d / distance)^4)^2` if there is a distance. The import is exact, with one exception. With
/// decay 2 the imported light keeps growing at distances below 0.1, where the factor of three.js stays
/// at 100.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Three {
    /// `angle`: the half angle in radians from which on there is no light, in (0, pi/2].
    pub angle: f32,
    /// `penumbra`: the fraction of `angle` over which the light falls off, in [0, 1]; 0 gives a
    /// step.
    pub penumbra: f32,
    /// `distance`: the distance from which on there is no light, from 0.001 to 1e9; 0 for no range.
    pub distance: f32,
    /// `decay`: the exponent of the attenuation, from 0 to 16.
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
    /// Returns the spotlight at a position, pointing in a direction. In three.js the direction
    /// points from the position to the target.
    ///
    /// # Errors
    /// A parameter out of its range; a position or direction that [`SpotLight::new`] rejects.
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
        // The distance at which d^decay is 0.01.
        let stop = real_power(0.01, 1.0 / f64::from(self.decay));
        let fall = fall::decay(self.decay, stop, range, self.intensity)?;
        spot(position, direction, cone, Difference::NONE, fall)
    }
}
