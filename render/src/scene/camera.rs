//! A camera that orbits a target.

use core::f32::consts::{FRAC_PI_2, TAU};
use glam::{Vec2, Vec3};
use luminaire::{Angle, HalfAngle};

/// Depth of the near plane: the least depth that is drawn, in metres along the direction of sight.
pub(crate) const NEAR: f32 = 0.05;
/// Range of the distance between the camera and its target, in metres.
const DISTANCE: (f32, f32) = (0.25, 100.0);
/// Range of the vertical field of view, in radians.
const FIELD_OF_VIEW: (f32, f32) = (0.05, 2.5);
/// Largest pitch in radians, with the camera looking down from above: a little below the zenith,
/// where yaw is undefined.
const STEEPEST: f32 = 1.5;
/// Minimum height of the eye above the floor at y = 0, in metres.
const EYE_HEIGHT: f32 = 0.05;

/// A camera that orbits a target, in a right-handed world whose y axis points up.
///
/// At yaw 0 the eye is on the side of positive z, and x points to the right of the picture. A
/// positive yaw turns the camera to the right around the target. Parameters are clamped to their
/// ranges, and NaN is ignored, so that every camera is valid.
///
/// ```
/// use luminaire::Vec3;
/// use luminaire_render::Camera;
/// let mut camera = Camera::new(Vec3::new(0.0, 1.0, 0.0), 8.0, 0.0, 0.0, 0.6);
/// assert_eq!(camera.eye(), Vec3::new(0.0, 1.0, 8.0));
/// camera.orbit(0.0, -3.0); // as low as the floor lets it
/// assert!(camera.eye().y > 0.0);
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Camera {
    target: Vec3,
    distance: f32,
    yaw: f32,
    pitch: f32,
    field_of_view: f32,
}

impl Camera {
    /// Creates a camera at a distance of 0.25 to 100 metres from its target.
    ///
    /// Yaw, pitch and the vertical field of view (0.05 to 2.5) are in radians. With a positive
    /// pitch the camera looks down from above.
    pub fn new(
        target: luminaire::Vec3<f32>,
        distance: f32,
        yaw: f32,
        pitch: f32,
        field_of_view: f32,
    ) -> Self {
        let mut camera = Self {
            target: Vec3::from(target.map(|c| clamp(c, (-1e4, 1e4), 0.0))),
            distance: clamp(distance, DISTANCE, 10.0),
            yaw: 0.0,
            pitch: 0.0,
            field_of_view: clamp(field_of_view, FIELD_OF_VIEW, 0.6),
        };
        camera.orbit(yaw, pitch);
        camera
    }

    /// Turns the camera around its target by these angles in radians. The eye stays above the floor
    /// and below the zenith.
    pub fn orbit(&mut self, yaw: f32, pitch: f32) {
        let turned = (self.yaw + yaw) % TAU;
        self.yaw = if turned.is_finite() { turned } else { self.yaw };
        let raised = self.pitch + if pitch.is_nan() { 0.0 } else { pitch };
        self.pitch = raised.min(STEEPEST).max(self.lowest());
    }

    /// Multiplies the distance by a factor; a factor under 1 moves the camera nearer. The distance
    /// stays between 0.25 and 100 metres.
    pub fn zoom(&mut self, factor: f32) {
        self.distance = clamp(self.distance * factor, DISTANCE, self.distance);
        self.orbit(0.0, 0.0);
    }

    /// Returns the position of the eye, in metres.
    pub fn eye(&self) -> luminaire::Vec3<f32> {
        self.pose().eye.into()
    }

    /// Returns the pitch in radians; it is positive if the camera looks down.
    pub fn pitch(&self) -> f32 {
        self.pitch
    }

    /// Returns the distance from the target, in metres.
    pub fn distance(&self) -> f32 {
        self.distance
    }

    /// Projects a point to a picture whose width is `aspect` times its height. Returns the distances
    /// from the left and from the top border, as shares of the width and of the height, and the
    /// depth in metres. Points beside the picture have shares outside [0, 1]; `None` for a point that
    /// is not beyond the near plane, 0.05 metres from the eye.
    pub fn project(&self, point: luminaire::Vec3<f32>, aspect: f32) -> Option<[f32; 3]> {
        let pose = self.pose();
        let way = Vec3::from(point) - pose.eye;
        let depth = way.dot(pose.ahead);
        let tall = self.tangent();
        let place = |along: f32, tangent: f32| 0.5 + 0.5 * along / (tangent * depth);
        (depth > NEAR)
            .then(|| [place(way.dot(pose.right), aspect * tall), place(-way.dot(pose.up), tall), depth])
    }

    /// Returns the vector from the eye to a place of the picture at depth 1: the inverse of
    /// [`project`](Self::project). The place is given as shares of the width and of the height.
    pub fn toward(&self, [x, y]: [f32; 2], aspect: f32) -> luminaire::Vec3<f32> {
        let (pose, tall) = (self.pose(), self.tangent());
        let (right, up) = ((2.0 * x - 1.0) * aspect * tall, (1.0 - 2.0 * y) * tall);
        (pose.ahead + right * pose.right + up * pose.up).into()
    }

    /// Returns the tangent of half the vertical field of view.
    fn tangent(&self) -> f32 {
        let half_angle = Vec2::from_angle(self.field_of_view / 2.0);
        half_angle.y / half_angle.x
    }

    /// Returns the target, in metres.
    pub fn target(&self) -> luminaire::Vec3<f32> {
        self.target.into()
    }

    /// Returns the vertical field of view, in radians.
    pub fn field_of_view(&self) -> f32 {
        self.field_of_view
    }

    /// Returns the eye and the camera's right, up and forward directions.
    pub(crate) fn pose(&self) -> Pose {
        let (turn, rise) = (Vec2::from_angle(self.yaw), Vec2::from_angle(self.pitch));
        let right = Vec3::new(turn.x, 0.0, -turn.y);
        let ahead = -Vec3::new(turn.y * rise.x, rise.y, turn.x * rise.x);
        Pose { eye: self.target - self.distance * ahead, right, up: right.cross(ahead), ahead }
    }

    /// Returns the lowest pitch that keeps the eye above the floor. The result is [`STEEPEST`] if
    /// the target is so far below the floor that no pitch suffices.
    fn lowest(&self) -> f32 {
        let sine = ((EYE_HEIGHT - self.target.y) / self.distance).clamp(-1.0, 1.0);
        let from_zenith = HalfAngle::from(Angle::from_versine(1.0 - sine));
        (FRAC_PI_2 - from_zenith.to_radians()).clamp(-STEEPEST, STEEPEST)
    }
}

/// A camera's eye and its orthonormal axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    pub(crate) eye: Vec3,
    pub(crate) right: Vec3,
    pub(crate) up: Vec3,
    pub(crate) ahead: Vec3,
}

/// Clamps a value to a range. NaN becomes the default.
fn clamp(value: f32, (least, most): (f32, f32), default: f32) -> f32 {
    if value.is_nan() { default } else { value.clamp(least, most) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ASPECT: f32 = 16.0 / 9.0;

    #[test]
    fn a_projected_point_lies_toward_its_place() {
        for (yaw, pitch, field_of_view) in [(0.0, 0.0, 0.6), (2.5, 1.4, 2.0), (-0.7, 0.2, 0.06)] {
            let target = luminaire::Vec3::new(-1.0, 2.0, 3.0);
            let camera = Camera::new(target, 7.0, yaw, pitch, field_of_view);
            let [x, y, depth] = camera.project(target, ASPECT).unwrap();
            assert!((x - 0.5).abs() < 1e-4 && (y - 0.5).abs() < 1e-4 && (depth - 7.0).abs() < 1e-4);
            for place in [[0.5, 0.5], [0.0, 0.0], [0.9, 0.2], [-0.5, 1.5]] {
                for depth in [0.1, 3.0, 50.0] {
                    let way = Vec3::from(camera.toward(place, ASPECT));
                    let point = Vec3::from(camera.eye()) + depth * way;
                    let [x, y, found] = camera.project(point.into(), ASPECT).unwrap();
                    assert!(
                        (x - place[0]).abs() < 1e-4 && (y - place[1]).abs() < 1e-4,
                        "{x} {y} for {place:?}"
                    );
                    assert!((found - depth).abs() < 1e-4 * depth, "{found} for {depth}");
                }
            }
            assert_eq!(camera.project(camera.eye(), ASPECT), None);
            let behind = Vec3::from(camera.eye()) - Vec3::from(camera.toward([0.5, 0.5], ASPECT));
            assert_eq!(camera.project(behind.into(), ASPECT), None);
        }
    }
}
