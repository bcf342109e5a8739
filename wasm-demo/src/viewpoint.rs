//! The visitor's offset from the scene's own camera.

use luminaire_render::Camera;

/// A rotation about the target of a camera and a factor on its distance. The same offset also
/// applies to a moving camera.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Viewpoint {
    yaw: f32,
    pitch: f32,
    factor: f32,
}

impl Viewpoint {
    /// No offset.
    pub(crate) const ORIGINAL: Self = Self { yaw: 0.0, pitch: 0.0, factor: 1.0 };

    /// Applies the offset to a camera.
    pub(crate) fn of(&self, camera: Camera) -> Camera {
        let mut moved = camera;
        moved.zoom(self.factor);
        moved.orbit(self.yaw, self.pitch);
        moved
    }

    /// Rotates by angles in radians. A step that does not move the camera, because the camera is at
    /// its limit, is not stored, so that it need not be undone.
    pub(crate) fn orbit(&mut self, camera: Camera, yaw: f32, pitch: f32) {
        self.follow(camera, Self { yaw: self.yaw + yaw, ..*self });
        self.follow(camera, Self { pitch: self.pitch + pitch, ..*self });
    }

    /// Multiplies the distance by `factor`. A step that does not move the camera is not stored.
    pub(crate) fn zoom(&mut self, camera: Camera, factor: f32) {
        self.follow(camera, Self { factor: self.factor * factor, ..*self });
    }

    fn follow(&mut self, camera: Camera, other: Self) {
        let is_finite = [other.yaw, other.pitch, other.factor].iter().all(|number| number.is_finite());
        if is_finite && other.of(camera) != self.of(camera) {
            *self = other;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luminaire::Vec3;

    const CAMERA: fn() -> Camera = || Camera::new(Vec3::new(0.0, 1.0, 0.0), 8.0, 0.0, 0.2, 0.6);

    #[test]
    fn a_visitor_may_come_back() {
        let camera = CAMERA();
        let mut viewpoint = Viewpoint::ORIGINAL;
        assert_eq!(viewpoint.of(camera), camera);
        viewpoint.orbit(camera, 0.5, 0.25);
        viewpoint.zoom(camera, 0.5);
        assert_ne!(viewpoint.of(camera), camera);
        viewpoint.zoom(camera, 2.0);
        viewpoint.orbit(camera, -0.5, -0.25);
        assert_eq!(viewpoint, Viewpoint::ORIGINAL);
    }

    #[test]
    fn what_the_camera_does_not_follow_is_not_kept() {
        let camera = CAMERA();
        let mut viewpoint = Viewpoint::ORIGINAL;
        for _ in 0..100 {
            viewpoint.orbit(camera, 0.0, 0.25);
            viewpoint.zoom(camera, 2.0);
        }
        let (high, far) = (viewpoint.of(camera), viewpoint);
        viewpoint.orbit(camera, 0.0, -0.5);
        assert_ne!(viewpoint.of(camera), high);
        viewpoint.zoom(camera, 0.5);
        assert_ne!(viewpoint.of(camera).eye(), far.of(camera).eye());
        let before = viewpoint;
        viewpoint.orbit(camera, f32::NAN, f32::NAN);
        viewpoint.zoom(camera, f32::NAN);
        assert_eq!(viewpoint, before);
    }
}
