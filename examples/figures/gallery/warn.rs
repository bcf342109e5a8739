//! Warn's spotlight, the model that the paper compares with.

use luminaire::{Angle, HalfAngle, Vec3};
use support::format::Format;

/// The cosine of the angle off axis, raised to a non-integer exponent (Warn 1983; Hast 2004, equation 1),
/// in f64.
///
/// Power, logarithm and cosine come from `libm`, whose results are the same on every machine.
#[derive(Clone, Copy)]
pub(crate) struct Warn {
    pub(crate) exponent: f64,
}

impl Warn {
    /// The model with this field angle: the intensity at its edge is 1/10.
    pub(crate) fn from_field(field: Angle) -> Self {
        let half = f64::from(HalfAngle::from(field).to_degrees()).to_radians();
        Self { exponent: libm::log(0.1) / libm::log(libm::cos(half)) }
    }

    /// The intensity at the cosine of an angle off axis, which is 0 from 90 degrees on.
    pub(crate) fn falloff(self, cosine: f64) -> f64 {
        if cosine > 0.0 { libm::pow(cosine, self.exponent) } else { 0.0 }
    }

    /// The full angle in degrees at whose edge the intensity has this value.
    pub(crate) fn angle_at(self, intensity: f64) -> f64 {
        2.0 * libm::acos(libm::pow(intensity, 1.0 / self.exponent)).to_degrees()
    }

    /// The irradiance at a surface point as in the kernel: falloff, Lambert's cosine and the
    /// inverse square of the distance.
    pub(crate) fn irradiance(
        self,
        light: &luminaire::SpotLight<luminaire::falloff::SoftOrHard>,
        point: Vec3<f32>,
        normal: Vec3<f32>,
    ) -> f64 {
        let way = f32::exact_point(point.zip(light.position(), |p, l| p - l));
        let (axis, normal) = (f32::exact_direction(light.axis()), f32::exact_normal(normal));
        let (squared, distance) = (way.length_squared(), way.length());
        let incidence = (-way.dot(normal) / distance).max(0.0);
        f64::from(light.intensity()) * self.falloff(way.dot(axis) / distance) * incidence / squared
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tenth_is_left_at_the_field_angle() {
        let warn = Warn::from_field(Angle::degrees(15.0));
        assert!((warn.exponent - 267.993).abs() < 1e-3, "{}", warn.exponent);
        assert!((warn.falloff(libm::cos(7.5_f64.to_radians())) - 0.1).abs() < 1e-12);
        assert!((warn.angle_at(0.1) - 15.0).abs() < 1e-9);
        assert_eq!((warn.falloff(1.0), warn.falloff(0.0), warn.falloff(-1.0)), (1.0, 0.0, 0.0));
    }
}
