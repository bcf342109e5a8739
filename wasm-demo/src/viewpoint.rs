//! The visitor's offset from the scene's own camera.

use luminaire_render::{Camera, scenes::Example};

/// How far a visitor may move the camera of a scene from its own: beyond that, the backs of slabs, a curtain, the unlit
/// side or the void around the scene would fill the picture.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Reach {
    /// Largest yaw to either side, in radians.
    yaw: f32,
    /// Least and largest pitch, in radians.
    pitch: [f32; 2],
    /// Least and largest factor on the distance.
    factor: [f32; 2],
}

impl Reach {
    /// The reach in a scene.
    pub(crate) fn of(scene: Example) -> Self {
        let all_around = f32::INFINITY;
        let (yaw, pitch, factor) = match scene {
            Example::BareSpot => (1.2, [-0.1, 1.4], [0.3, 1.3]),
            Example::Pocket => (1.2, [-0.1, 1.4], [0.5, 1.5]),
            Example::Tree => (all_around, [-2.0, 2.0], [0.3, 3.0]),
            Example::ThreePoint => (0.75, [0.0, 1.3], [0.3, 1.15]),
            Example::Grid => (all_around, [-0.15, 2.0], [0.3, 1.2]),
            Example::Turntable => (1.2, [-0.05, 1.4], [0.3, 1.5]),
            Example::Show => (all_around, [-2.0, 2.0], [0.3, 1.4]),
            Example::Gallery => (0.8, [-0.05, 1.4], [0.3, 1.3]),
        };
        Self { yaw, pitch, factor }
    }

    /// The value nearest to another one between two ends.
    fn within([least, most]: [f32; 2], value: f32) -> f32 {
        value.max(least).min(most)
    }
}

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

    /// Applies the offset to a camera, within its reach.
    pub(crate) fn of(&self, camera: Camera, reach: Reach) -> Camera {
        let mut moved = camera;
        moved.zoom(Reach::within(reach.factor, self.factor));
        moved.orbit(Reach::within([-reach.yaw, reach.yaw], self.yaw), Reach::within(reach.pitch, self.pitch));
        moved
    }

    /// The offset without what goes beyond the camera's limits, so that the next step back is
    /// followed.
    fn within(&self, camera: Camera, reach: Reach) -> Self {
        /// Share by which rounding changes an offset at most.
        const ROUNDING: f32 = 1e-3;
        let moved = self.of(camera, reach);
        let (pitch, factor) = (moved.pitch() - camera.pitch(), moved.distance() / camera.distance());
        Self {
            pitch: if (pitch - self.pitch).abs() > ROUNDING { pitch } else { self.pitch },
            factor: if (factor / self.factor - 1.0).abs() > ROUNDING { factor } else { self.factor },
            yaw: Reach::within([-reach.yaw, reach.yaw], self.yaw),
        }
    }

    /// Rotates by angles in radians. A step that does not move the camera, because the camera is at
    /// its limit, is not stored, so that it need not be undone.
    pub(crate) fn orbit(&mut self, camera: Camera, reach: Reach, yaw: f32, pitch: f32) {
        let start = self.within(camera, reach);
        self.follow(camera, reach, Self { yaw: start.yaw + yaw, ..start });
        let start = self.within(camera, reach);
        self.follow(camera, reach, Self { pitch: start.pitch + pitch, ..start });
    }

    /// Multiplies the distance by `factor`. A step that does not move the camera is not stored.
    /// Returns whether it was.
    pub(crate) fn zoom(&mut self, camera: Camera, reach: Reach, factor: f32) -> bool {
        let start = self.within(camera, reach);
        self.follow(camera, reach, Self { factor: start.factor * factor, ..start })
    }

    fn follow(&mut self, camera: Camera, reach: Reach, other: Self) -> bool {
        let follows =
            Self::from_parts(other.parts()).is_some() && other.of(camera, reach) != self.of(camera, reach);
        if follows {
            *self = other;
        }
        follows
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::Stage;
    use luminaire::{Fx16, Vec3};
    use luminaire_render::Renderer;

    /// The limits of every camera.
    const FREE: Reach = Reach { yaw: f32::INFINITY, pitch: [-9.0, 9.0], factor: [0.0, f32::INFINITY] };

    const CAMERA: fn() -> Camera = || Camera::new(Vec3::new(0.0, 1.0, 0.0), 8.0, 0.0, 0.2, 0.6);

    #[test]
    fn a_visitor_may_come_back() {
        let camera = CAMERA();
        let mut viewpoint = Viewpoint::ORIGINAL;
        assert_eq!(viewpoint.of(camera, FREE), camera);
        viewpoint.orbit(camera, FREE, 0.5, 0.25);
        viewpoint.zoom(camera, FREE, 0.5);
        assert_ne!(viewpoint.of(camera, FREE), camera);
        viewpoint.zoom(camera, FREE, 2.0);
        viewpoint.orbit(camera, FREE, -0.5, -0.25);
        assert_eq!(viewpoint, Viewpoint::ORIGINAL);
    }

    #[test]
    fn a_small_step_leads_back_from_beyond_the_limits() {
        let camera = CAMERA();
        let mut viewpoint = Viewpoint::from_parts([0.0, 1.0, 1.0]).unwrap();
        for (pitch, factor) in [(3.0, 1e6), (-9.0, 1e-6)] {
            viewpoint.orbit(camera, FREE, 0.0, pitch);
            viewpoint.zoom(camera, FREE, factor);
            let limit = viewpoint.of(camera, FREE);
            viewpoint.orbit(camera, FREE, 0.0, -0.01 * pitch.signum());
            assert_ne!(viewpoint.of(camera, FREE).pitch(), limit.pitch());
            assert!(viewpoint.zoom(camera, FREE, if factor > 1.0 { 0.99 } else { 1.01 }));
        }
    }

    #[test]
    fn what_the_camera_does_not_follow_is_not_kept() {
        let camera = CAMERA();
        let mut viewpoint = Viewpoint::ORIGINAL;
        for _ in 0..100 {
            viewpoint.orbit(camera, FREE, 0.0, 0.25);
            viewpoint.zoom(camera, FREE, 2.0);
        }
        assert!(!viewpoint.zoom(camera, FREE, 2.0));
        let (high, far) = (viewpoint.of(camera, FREE), viewpoint);
        viewpoint.orbit(camera, FREE, 0.0, -0.5);
        assert_ne!(viewpoint.of(camera, FREE), high);
        viewpoint.zoom(camera, FREE, 0.5);
        assert_ne!(viewpoint.of(camera, FREE).eye(), far.of(camera, FREE).eye());
        let before = viewpoint;
        viewpoint.orbit(camera, FREE, f32::NAN, f32::NAN);
        viewpoint.zoom(camera, FREE, f32::NAN);
        assert_eq!(viewpoint, before);
    }

    /// Share of the pixels that are black, of a scene as it opens, from a viewpoint.
    fn dark(scene: Example, viewpoint: Viewpoint) -> f32 {
        let mut stage = Stage::of(scene).unwrap();
        stage.change(|state| state.viewpoint = viewpoint).unwrap();
        let mut renderer = Renderer::<Fx16>::new(96, 54).unwrap();
        renderer.draw_geometry(stage.rig().scene(), &stage.camera());
        renderer.draw_light(&stage.rig().fixtures_at(2.0).unwrap()).unwrap();
        let codes = renderer.encode();
        let black = codes.chunks_exact(4).filter(|pixel| pixel[..3].iter().all(|code| *code < 6)).count();
        black as f32 / (codes.len() / 4) as f32
    }

    #[test]
    fn no_view_is_black() {
        for &scene in Example::ALL {
            let lit = 1.0 - dark(scene, Viewpoint::ORIGINAL);
            // A scene without ambient light has an unlit side.
            let most = if lit > 0.95 { 0.2 } else { 1.0 - lit / 3.0 };
            for parts in [-2.0, 2.0].into_iter().flat_map(|yaw| {
                [-9.0, 9.0].into_iter().flat_map(move |pitch| [1e-6, 1e6].map(|factor| [yaw, pitch, factor]))
            }) {
                let found = dark(scene, Viewpoint::from_parts(parts).unwrap());
                assert!(found <= most, "{scene:?} at {parts:?}: {found}, expected at most {most}");
            }
        }
    }

    #[test]
    fn a_camera_at_the_end_of_its_reach_comes_back_at_once() {
        let (camera, reach) = (CAMERA(), Reach::of(Example::Gallery));
        let mut viewpoint = Viewpoint::ORIGINAL;
        for _ in 0..100 {
            viewpoint.orbit(camera, reach, 0.25, 0.25);
            viewpoint.zoom(camera, reach, 2.0);
        }
        let mut expected = viewpoint.of(camera, reach);
        expected.orbit(-0.25, -0.25);
        viewpoint.orbit(camera, reach, -0.25, -0.25);
        let off = viewpoint.of(camera, reach).eye().zip(expected.eye(), |found, expected| found - expected);
        assert!(off.dot(off) < 1e-6, "{off:?}");
        assert!(!viewpoint.zoom(camera, reach, 2.0) && viewpoint.zoom(camera, reach, 0.9));
    }
}
