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
