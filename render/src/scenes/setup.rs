//! What an example scene is made of.

use super::MovingLight;
use crate::{Camera, Display, Scene};
use alloc::vec::Vec;
use core::f32::consts::TAU;
use glam::Vec2;
use luminaire::{Error, projector::Fixture};

/// A scene with its camera, fixtures and display.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub struct Setup {
    /// The meshes, their materials, the ambient light and the haze.
    pub scene: Scene,
    /// The camera at second 0.
    pub camera: Camera,
    /// The fixtures, with their names and movements.
    pub fixtures: Vec<MovingLight>,
    /// The display that the picture is for.
    pub display: Display,
    /// Largest yaw of the camera to either side, in radians.
    pub(super) swing: f32,
}

/// Period of the camera's swing, in seconds.
const SWING_PERIOD: f32 = 24.0;

impl Setup {
    pub(super) fn new(scene: Scene, camera: Camera, fixtures: Vec<MovingLight>) -> Self {
        Self { scene, camera, fixtures, display: Display::default(), swing: 0.0 }
    }

    /// Returns the fixtures at a time in seconds, in the order of [`fixtures`](Self::fixtures).
    /// Equal times give equal fixtures.
    ///
    /// # Errors
    /// A time that is not finite, if something in the scene moves.
    pub fn fixtures_at(&self, seconds: f32) -> Result<Vec<Fixture>, Error> {
        self.fixtures.iter().map(|fixture| fixture.at(seconds)).collect()
    }

    /// Returns the camera at a time in seconds, for optional camera motion. In most scenes the
    /// camera stands still.
    pub fn camera_at(&self, seconds: f32) -> Camera {
        let mut camera = self.camera;
        camera.orbit(self.swing * Vec2::from_angle(TAU * seconds / SWING_PERIOD).y, 0.0);
        camera
    }
}
