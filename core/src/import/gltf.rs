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
/// The falloff is `t^2`, where `t` rises linearly in the cosine of the angle off axis, from 0 at
/// the outer angle to 1 at the inner angle. The attenuation is `(1 - (d / range)^4) / d^2`, at
/// least 0. The import is exact. The direction of a node is its local -z.
///
/// The code that the extension recommends clamps the difference between the cosines of the two
/// angles to at least 0.001. So a beam of half a degree is nearly dark on its axis.
/// [`import`](Self::import) omits that clamp;
/// [`import_as_recommended`](Self::import_as_recommended) includes it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Gltf {
    /// `innerConeAngle`: the half angle in radians up to which the intensity is full, from 0 to the
    /// outer half angle. Equal angles, which the extension does not allow, give a step.
    pub inner_cone_angle: f32,
    /// `outerConeAngle`: the half angle in radians from which on there is no light, in (0, pi/2].
    pub outer_cone_angle: f32,
    /// `range`: from 0.001 to 1e9; `None` for no range.
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
    /// Returns the spotlight at a position, pointing in a direction.
    ///
    /// # Errors
    /// A parameter out of its range; a position or direction that [`SpotLight::new`] rejects.
    pub fn import(
        &self,
        position: Vec3<f32>,
        direction: Vec3<f32>,
    ) -> Result<Imported<SpotLight<AnyFalloff, AnyAttenuation>>, Error> {
        let [inner, outer] = self.angles()?;
        let cone = ramp(AnyFalloff::Soft(Soft), inner, outer)?;
        self.spot(position, direction, cone, self.intensity)
    }

    /// Returns the spotlight of the code that the extension recommends, with its `max(0.001, ...)`.
    ///
    /// Images of this light match the images of other renderers that use the recommended code. The
    /// import is exact.
    ///
    /// If the cosines of the two angles differ by 0.001 or more, the result equals that of
    /// [`import`](Self::import). Otherwise the falloff rises over a span of 0.001 in the cosine,
    /// from the outer angle inwards. If the axis is inside that span, the light on the axis is less
    /// than the intensity.
    ///
    /// # Errors
    /// The same errors as [`import`](Self::import).
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

    /// Returns the inner and the outer angle.
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
