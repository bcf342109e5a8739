//! The square that a spotlight projects, in f64 and as plainly as it can be written.

use super::format::Format;
use super::oracle::DVec3;
use luminaire::{SpotLight, attenuation::Attenuation, falloff::Falloff};

/// The square around a cone: where its light stands, the vectors of its frame, and half its side at
/// a depth of one.
#[derive(Clone, Copy, Debug)]
pub struct Square {
    pub position: DVec3,
    pub right: DVec3,
    pub up: DVec3,
    pub axis: DVec3,
    pub tangent: f64,
}

impl Square {
    /// The square of a cone, with y upwards; a light that points straight down has the top of its
    /// square to `-z`, one that points straight up to `z`.
    pub fn new(position: DVec3, axis: DVec3, half_degrees: f64) -> Self {
        let axis = axis.normalize();
        let sine = axis.x.hypot(axis.z);
        let is_vertical = sine < 1.0_f64.to_radians().sin();
        let up = if is_vertical { axis.y.signum() * DVec3::Z } else { DVec3::Y };
        let right = axis.cross(up).normalize();
        let tangent = half_degrees.to_radians().tan();
        Self { position, right, up: right.cross(axis), axis, tangent }
    }

    /// The square of a spotlight as a format stores it, turned clockwise.
    pub fn stored<S: Format, P: Falloff, A: Attenuation>(
        spot: &SpotLight<P, A>,
        half_degrees: f64,
        roll: f64,
    ) -> Self {
        let position = S::exact_point(spot.position().map(S::length));
        let axis = S::exact_direction(S::axis(spot.axis()));
        Self::new(position, axis, half_degrees).turned(roll)
    }

    /// Turned clockwise, as it is seen from the light.
    pub fn turned(self, degrees: f64) -> Self {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let right = cosine * self.right - sine * self.up;
        let up = cosine * self.up + sine * self.right;
        Self { right, up, ..self }
    }

    /// The ways from the left and the top edge to a point, in sides, and its depth.
    pub fn project(&self, point: DVec3) -> [f64; 3] {
        let way = point - self.position;
        let depth = way.dot(self.axis);
        let side = 2.0 * self.tangent * depth;
        [0.5 + way.dot(self.right) / side, 0.5 - way.dot(self.up) / side, depth]
    }

    /// A point at these ways from the left and the top edge, in sides, and this depth.
    pub fn point(&self, [column, row, depth]: [f64; 3]) -> DVec3 {
        let side = 2.0 * self.tangent * depth;
        let (right, up) = ((column - 0.5) * side, (0.5 - row) * side);
        self.position + depth * self.axis + right * self.right + up * self.up
    }
}
