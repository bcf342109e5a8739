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

    /// Creates an offset from its yaw and pitch in radians and its factor; `None` if one of them is
    /// not finite or the factor is not positive.
    pub(crate) fn from_parts([yaw, pitch, factor]: [f32; 3]) -> Option<Self> {
        let is_valid = yaw.is_finite() && pitch.is_finite() && factor.is_finite() && factor > 0.0;
        is_valid.then_some(Self { yaw, pitch, factor })
    }

    /// Returns what [`Self::from_parts`] takes.
    pub(crate) fn parts(&self) -> [f32; 3] {
        [self.yaw, self.pitch, self.factor]
    }

    /// Applies the offset to a camera.
    pub(crate) fn of(&self, camera: Camera) -> Camera {
        let mut moved = camera;
        moved.zoom(self.factor);
        moved.orbit(self.yaw, self.pitch);
        moved
    }

    /// The offset without what goes beyond the camera's limits, so that the next step back is
    /// followed.
    fn within(&self, camera: Camera) -> Self {
        /// Share by which rounding changes an offset at most.
        const ROUNDING: f32 = 1e-3;
        let moved = self.of(camera);
        let (pitch, factor) = (moved.pitch() - camera.pitch(), moved.distance() / camera.distance());
        Self {
            pitch: if (pitch - self.pitch).abs() > ROUNDING { pitch } else { self.pitch },
            factor: if (factor / self.factor - 1.0).abs() > ROUNDING { factor } else { self.factor },
            ..*self
        }
    }

    /// Rotates by angles in radians. A step that does not move the camera, because the camera is at
    /// its limit, is not stored, so that it need not be undone.
    pub(crate) fn orbit(&mut self, camera: Camera, yaw: f32, pitch: f32) {
        let start = self.within(camera);
        self.follow(camera, Self { yaw: start.yaw + yaw, ..start });
        let start = self.within(camera);
        self.follow(camera, Self { pitch: start.pitch + pitch, ..start });
    }

    /// Multiplies the distance by `factor`. A step that does not move the camera is not stored.
    /// Returns whether it was.
    pub(crate) fn zoom(&mut self, camera: Camera, factor: f32) -> bool {
        let start = self.within(camera);
        self.follow(camera, Self { factor: start.factor * factor, ..start })
    }

    fn follow(&mut self, camera: Camera, other: Self) -> bool {
        let follows = Self::from_parts(other.parts()).is_some() && other.of(camera) != self.of(camera);
        if follows {
            *self = other;
        }
        follows
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
    fn a_small_step_leads_back_from_beyond_the_limits() {
        let camera = CAMERA();
        let mut viewpoint = Viewpoint::from_parts([0.0, 1.0, 1.0]).unwrap();
        for (pitch, factor) in [(3.0, 1e6), (-9.0, 1e-6)] {
            viewpoint.orbit(camera, 0.0, pitch);
            viewpoint.zoom(camera, factor);
            let limit = viewpoint.of(camera);
            viewpoint.orbit(camera, 0.0, -0.01 * pitch.signum());
            assert_ne!(viewpoint.of(camera).pitch(), limit.pitch());
            assert!(viewpoint.zoom(camera, if factor > 1.0 { 0.99 } else { 1.01 }));
        }
    }

    #[test]
    fn what_the_camera_does_not_follow_is_not_kept() {
        let camera = CAMERA();
        let mut viewpoint = Viewpoint::ORIGINAL;
        for _ in 0..100 {
            viewpoint.orbit(camera, 0.0, 0.25);
            viewpoint.zoom(camera, 2.0);
        }
        assert!(!viewpoint.zoom(camera, 2.0));
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
