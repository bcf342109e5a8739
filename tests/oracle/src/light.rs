//! The spotlight.

use glam::DVec3;

use crate::{Attenuation, Cone, versine_between};

/// A spotlight.
#[derive(Clone, Copy, Debug)]
pub struct SpotLight {
    /// Its position.
    pub position: DVec3,
    /// The direction that it shines in, of any length.
    pub axis: DVec3,
    /// Its cone.
    pub cone: Cone,
    /// The intensity on the axis.
    pub intensity: f64,
    /// The attenuation over the distance.
    pub attenuation: Attenuation,
}

impl SpotLight {
    /// A light of intensity 1 with the inverse square.
    pub fn new(position: impl Into<DVec3>, axis: impl Into<DVec3>, cone: Cone) -> Self {
        let (position, axis) = (position.into(), axis.into());
        Self { position, axis, cone, intensity: 1.0, attenuation: Attenuation::InverseSquare }
    }

    /// The versine of the angle off axis.
    pub fn versine(&self, point: DVec3) -> f64 {
        versine_between(point - self.position, self.axis)
    }

    /// The falloff of the cone at a point.
    pub fn falloff(&self, point: DVec3) -> f64 {
        self.cone.falloff(self.versine(point))
    }

    /// The light that arrives at a surface that faces the light: intensity x falloff x attenuation.
    pub fn arriving(&self, point: DVec3) -> f64 {
        self.intensity * self.falloff(point) * self.attenuation.at(point.distance(self.position))
    }

    /// The light that arrives at a surface point, by Lambert's cosine. That of a stored normal,
    /// which may be too long by its rounding, is capped at 1.
    pub fn irradiance(&self, point: DVec3, normal: DVec3) -> f64 {
        let to_light = (self.position - point).normalize();
        self.arriving(point) * to_light.dot(normal).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{soft, versine};

    #[test]
    fn irradiance_is_the_product_of_falloff_cosine_and_distance() {
        let cone = Cone::new(soft, versine(60.0));
        let light = SpotLight { intensity: 8.0, ..SpotLight::new([1.0, 2.0, 3.0], [0.0, -7.0, 0.0], cone) };
        let below = DVec3::new(1.0, 0.0, 3.0);
        assert_eq!(light.irradiance(below, DVec3::Y), 2.0);
        assert_eq!(light.irradiance(below, -DVec3::Y), 0.0);
        assert_eq!(light.irradiance(below, 1.001 * DVec3::Y), 2.0);
        // 45 degrees off axis on a floor: versine 0.2929, t = 0.4142, twice the squared distance.
        let aside = DVec3::new(3.0, 0.0, 3.0);
        let t = core::f64::consts::SQRT_2 - 1.0;
        let exact = t * t * core::f64::consts::FRAC_1_SQRT_2;
        assert!((light.irradiance(aside, DVec3::Y) - exact).abs() < 1e-15);
        let even = SpotLight { attenuation: Attenuation::None, ..light };
        assert!((even.irradiance(aside, DVec3::Y) - 8.0 * exact).abs() < 1e-14);
    }
}
