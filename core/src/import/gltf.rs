//! Lights of glTF.

use super::{AnyAttenuation, Difference, Imported, fall::Fall, ramp, spot};
use crate::{
    angle::{Angle, HalfAngle},
    attenuation::{GltfRange, InverseSquare},
    cone::Cone,
    error::{Error, Parameter, check_between, check_up_to},
    falloff::{AnyFalloff, Soft},
    light::SpotLight,
    vec3::Vec3,
};

/// A spotlight of glTF's extension `KHR_lights_punctual`, with its defaults.
///
/// The square of the ramp between the cosines of the two angles, and `(1 - (d / range)^4) / d^2`,
/// at least 0. Exact. A node's direction is its local -z.
///
/// The code that the extension recommends takes at least 0.001 for the difference of the two
/// cosines, so that a beam of half a degree is nearly dark on its axis. [`import`](Self::import)
/// leaves that out;
/// [`import_as_recommended`](Self::import_as_recommended) has it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Gltf {
    /// `innerConeAngle`: the half angle in radians where the light begins to fall, from 0 to the
    /// outer one. At the outer one, which the extension does not allow, it is a step.
    pub inner_cone_angle: f32,
    /// `outerConeAngle`: the half angle in radians where the light ends, more than 0 and at most pi
    /// / 2.
    pub outer_cone_angle: f32,
    /// `range`: from 0.001 to 1e9, if there is one.
    pub range: Option<f32>,
    /// `intensity`: in candela, from 0 to 1e9. One candela lights a facing surface at distance 1 to
    /// full scale.
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
    /// A parameter out of its range; a position or direction that [`SpotLight::new`] refuses.
    pub fn import(
        &self,
        position: Vec3<f32>,
        direction: Vec3<f32>,
    ) -> Result<Imported<SpotLight<AnyFalloff, AnyAttenuation>>, Error> {
        let [inner, outer] = self.angles()?;
        let cone = ramp(AnyFalloff::Soft(Soft), inner, outer)?;
        self.spot(position, direction, cone, self.intensity)
    }

    /// The spotlight by the code that the extension recommends, with its `max(0.001, ...)`: for
    /// pictures that are to match those of other renderers. The same light as by
    /// [`import`](Self::import) where the cosines of the angles are 0.001 apart or more. Where they
    /// are nearer the ramp still spans 0.001, from the outer angle inwards; an axis that it ends
    /// before has less than the intensity of the light. Exact.
    ///
    /// # Errors
    /// As [`import`](Self::import).
    pub fn import_as_recommended(
        &self,
        position: Vec3<f32>,
        direction: Vec3<f32>,
    ) -> Result<Imported<SpotLight<AnyFalloff, AnyAttenuation>>, Error> {
        const LEAST_SPAN: f32 = 1e-3;
        let [inner, outer] = self.angles()?;
        let versine = outer.versine();
        let on_axis = (versine / LEAST_SPAN).min(1.0);
        let widest = Angle::from_versine((versine - LEAST_SPAN).max(0.0));
        let cone = ramp(AnyFalloff::Soft(Soft), if inner < widest { inner } else { widest }, outer)?;
        self.spot(position, direction, cone, self.intensity * on_axis * on_axis)
    }

    /// The inner and the outer angle.
    fn angles(&self) -> Result<[Angle; 2], Error> {
        check_up_to(Parameter::OuterConeAngle, self.outer_cone_angle, core::f32::consts::FRAC_PI_2)?;
        check_between(Parameter::InnerConeAngle, self.inner_cone_angle, 0.0, self.outer_cone_angle)?;
        Ok([self.inner_cone_angle, self.outer_cone_angle].map(|half| HalfAngle::radians(half).into()))
    }

    fn spot(
        &self,
        position: Vec3<f32>,
        direction: Vec3<f32>,
        cone: Cone<AnyFalloff>,
        intensity: f32,
    ) -> Result<Imported<SpotLight<AnyFalloff, AnyAttenuation>>, Error> {
        let distance = AnyAttenuation::GltfRange(GltfRange::new(InverseSquare, self.range)?);
        spot(position, direction, cone, Difference::NONE, Fall { distance, intensity, difference: 0.0 })
    }
}
