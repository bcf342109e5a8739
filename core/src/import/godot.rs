//! Lights of Godot.

use super::{
    AnyAttenuation, Difference, Imported,
    fall::{self, Fall},
    ramp, spot,
};
use crate::{
    angle::{Angle, HalfAngle},
    error::{Error, Parameter, check_between, check_up_to},
    falloff::{AnyFalloff, InvertedRealPower},
    light::SpotLight,
    vec3::Vec3,
};

/// A `SpotLight3D` of Godot 4 (`scene_forward_lights_inc.glsl` and `light_storage.cpp`), with its
/// defaults.
///
/// `u` is the versine of the angle off axis, divided by the versine of the spot angle. The falloff
/// is `1 - max(0.0001, u)^p` with `p = 1 / spot_angle_attenuation`. Godot computes this reciprocal
/// when it fills its light buffer. An angle attenuation of 1, 1/2, 1/3 and so on gives an integer
/// p. For such a p, the import is `1 - u^p`, which differs from Godot by `0.0001^p` on the axis.
/// For any other p the import is exact: the falloff keeps the `max`, and the intensity is scaled to
/// Godot's value on the axis.
///
/// The attenuation is `max(d, 0.0001)^-spot_attenuation` with Filament's window
/// `(1 - (d / spot_range)^4)^2`. The import is exact, with two exceptions. With exponent 2 the
/// imported light keeps growing at distances below 0.0001. With an exponent over 4.8 it stops growing
/// where the factor is 2^64.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Godot {
    /// `spot_angle`: the half angle in degrees from which on there is no light, in (0, 90].
    pub spot_angle: f32,
    /// `spot_angle_attenuation`: from 1/128 to 128.
    pub spot_angle_attenuation: f32,
    /// `spot_range`: the distance from which on there is no light, from 0.001 to 1e9.
    pub spot_range: f32,
    /// `spot_attenuation`: the exponent of the attenuation, from 0 to 16.
    pub spot_attenuation: f32,
    /// `light_energy`: from 0 to 1e9.
    pub light_energy: f32,
}

/// Godot's minimum of u.
const FLOOR: f32 = 1e-4;

impl Default for Godot {
    fn default() -> Self {
        Self {
            spot_angle: 45.0,
            spot_angle_attenuation: 1.0,
            spot_range: 5.0,
            spot_attenuation: 1.0,
            light_energy: 1.0,
        }
    }
}

impl Godot {
    /// Returns the spotlight at a position, pointing in a direction. In Godot the direction is the
    /// local -z of the node.
    ///
    /// # Errors
    /// A parameter out of its range; a position or direction that [`SpotLight::new`] rejects.
    pub fn import(
        &self,
        position: Vec3<f32>,
        direction: Vec3<f32>,
    ) -> Result<Imported<SpotLight<AnyFalloff, AnyAttenuation>>, Error> {
        check_up_to(Parameter::SpotAngle, self.spot_angle, 90.0)?;
        let attenuation = self.spot_angle_attenuation;
        check_between(Parameter::SpotAngleAttenuation, attenuation, 1.0 / 128.0, 128.0)?;
        let exponent = 1.0 / attenuation;
        let floored = InvertedRealPower::of(exponent, FLOOR);
        let whole = exponent as u32;
        let (falloff, difference, on_axis) = if whole as f32 == exponent {
            let angle = (1.0 - floored.height()) as f32;
            (AnyFalloff::inverted_power(whole), Difference { angle: angle * 1.001, ..Difference::NONE }, 1.0)
        } else {
            (AnyFalloff::InvertedRealPower(floored), Difference::NONE, floored.height() as f32)
        };
        let outer = Angle::from(HalfAngle::degrees(self.spot_angle));
        let cone = ramp(falloff, Angle::degrees(0.0), outer)?;
        let fall = fall::decay(self.spot_attenuation, 1e-4, Some(self.spot_range), self.light_energy)?;
        let fall = Fall { intensity: fall.intensity * on_axis, ..fall };
        spot(position, direction, cone, difference, fall)
    }
}
