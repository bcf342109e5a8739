//! The square that a spotlight projects, in f64 and as plainly as it can be written; and the table
//! of its error bounds.

use super::bounds::REFUSE;
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
    pub fn place(&self, point: DVec3) -> [f64; 3] {
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

/// The bounds at one half angle, in `f32`, `Fx32` and `Fx16`, in this order: of a place, from the
/// middle of its step, in sides; and of the depth, relative. Measured and held as in
/// [`bounds`](super::bounds), two-sided and searched; `LUMINAIRE_FULL=1 cargo test --test suite
/// projection:: -- --nocapture --test-threads 1` prints the measured ones.
pub struct Row {
    /// In degrees; [`NARROWEST`] stands for a different angle in each format.
    pub half: f32,
    pub place: [f64; 3],
    pub depth: [f64; 3],
}

/// The narrowest cone of a format.
pub const NARROWEST: f32 = 0.0;

const fn row(half: f32, place: [f64; 3], depth: [f64; 3]) -> Row {
    Row { half, place, depth }
}

/// Half a step is 7.6e-6 of a side.
#[rustfmt::skip]
pub const ROWS: [Row; 12] = [
    row(NARROWEST, [7.0e-4, 8.1e-6, 8.5e-4], [2.4e-7, 1.6e-5, 1.3e-4]),
    row(0.01,      [2.5e-4, 7.9e-6, REFUSE], [2.4e-7, 1.6e-5, REFUSE]),
    row(0.1,       [3.0e-5, 7.9e-6, REFUSE], [2.4e-7, 1.6e-5, REFUSE]),
    row(0.5,       [1.2e-5, 7.9e-6, 7.7e-4], [2.4e-7, 1.6e-5, 1.3e-4]),
    row(1.0,       [9.9e-6, 7.9e-6, 4.1e-4], [2.4e-7, 1.6e-5, 1.3e-4]),
    row(2.0,       [9.0e-6, 7.9e-6, 2.4e-4], [2.4e-7, 1.6e-5, 1.3e-4]),
    row(3.5,       [8.4e-6, 7.9e-6, 1.7e-4], [2.4e-7, 1.6e-5, 1.3e-4]),
    row(7.5,       [8.2e-6, 7.9e-6, 1.2e-4], [2.4e-7, 1.6e-5, 1.3e-4]),
    row(15.0,      [8.1e-6, 7.9e-6, 1.1e-4], [2.4e-7, 1.6e-5, 1.4e-4]),
    row(30.0,      [8.0e-6, 7.9e-6, 1.1e-4], [2.4e-7, 1.6e-5, 1.5e-4]),
    row(60.0,      [8.0e-6, 7.9e-6, 1.8e-4], [3.1e-7, 1.6e-5, 2.7e-4]),
    row(80.0,      [8.2e-6, 8.1e-6, 4.5e-4], [6.3e-7, 1.6e-5, 8.0e-4]),
];
