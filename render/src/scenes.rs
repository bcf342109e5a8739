//! Example scenes with different effects: from one bare spotlight to a stage full of lights.
//!
//! ```
//! use luminaire_render::{Renderer, scenes::Example};
//! let setup = Example::ThreePoint.setup()?;
//! let mut renderer = Renderer::<f32>::new(320, 180)?;
//! renderer.draw_geometry(&setup.scene, &setup.camera);
//! renderer.draw_light(&setup.fixtures_at(0.0)?)?;
//! assert!(renderer.encode().chunks_exact(4).any(|pixel| pixel[0] > 200));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bare_spot;
mod fixture;
mod gallery;
pub mod gobos;
mod grid;
mod pocket;
mod room;
mod show;
pub(crate) mod solids;
pub mod stage;
mod three_point;
mod turntable;

pub use self::{fixture::MovingLight, turntable::turntable};

use crate::{Camera, Display, Scene};
use alloc::vec::Vec;
use core::f32::consts::TAU;
use glam::Vec2;
use luminaire::{
    Error,
    dynamic::{Effect, Effects},
    projector::Fixture,
};

/// An example scene.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Example {
    /// One soft spotlight on a vase.
    BareSpot,
    /// Key, fill and back light on a still life.
    ThreePoint,
    /// A floor under 64 narrow spotlights.
    Grid,
    /// The floor of `Grid` under 8 wide spotlights, whose cones cover the same area as the 64
    /// narrow spotlights.
    WideGrid,
    /// Pictures and sculptures in the light of many kinds of lights.
    Gallery,
    /// Moving heads in a dark theatre.
    Show,
    /// A still life for the display of a microcontroller.
    Pocket,
    /// Four shiny solids under eight spotlights, which all move.
    Turntable,
}

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
    swing: f32,
}

/// Period of the camera's swing, in seconds.
const SWING_PERIOD: f32 = 24.0;

impl Example {
    /// All examples, ordered by the number of effects that they need, fewest first.
    pub const ALL: &[Self] = &[
        Self::BareSpot,
        Self::Pocket,
        Self::ThreePoint,
        Self::Grid,
        Self::WideGrid,
        Self::Turntable,
        Self::Show,
        Self::Gallery,
    ];

    /// Returns the name for files and addresses: one word, or words joined by hyphens.
    pub const fn name(self) -> &'static str {
        match self {
            Self::BareSpot => "bare-spot",
            Self::ThreePoint => "three-point",
            Self::Grid => "grid",
            Self::WideGrid => "wide-grid",
            Self::Gallery => "gallery",
            Self::Show => "show",
            Self::Pocket => "pocket",
            Self::Turntable => "turntable",
        }
    }

    /// Returns the title.
    pub const fn title(self) -> &'static str {
        match self {
            Self::BareSpot => "One bare spot",
            Self::ThreePoint => "Three-point lighting",
            Self::Grid => "A grid of 64 spots",
            Self::WideGrid => "A grid of 8 wide spots",
            Self::Gallery => "A gallery",
            Self::Show => "A show",
            Self::Pocket => "A pocket display",
            Self::Turntable => "A turntable",
        }
    }

    /// Returns one sentence about the effects that the scene needs.
    pub const fn summary(self) -> &'static str {
        match self {
            Self::BareSpot => {
                "One spot with a soft edge on matte surfaces, and nothing else: no ambient light."
            }
            Self::ThreePoint => {
                "Key, fill and back light with the edges that two angles of a data sheet ask for, ambient light, and two shadows."
            }
            Self::Grid => "64 narrow spots with a soft edge: each lights a sixty-fourth of the floor.",
            Self::WideGrid => "8 wide spots with a soft edge, which light as many square metres as the 64.",
            Self::Gallery => {
                "26 lights of every kind, falloff and distance model, and highlights on the few things that shine."
            }
            Self::Show => {
                "Moving heads with coloured beams in haze, soft and hard, and two turning gobos, in a house without ambient light."
            }
            Self::Pocket => {
                "One spot with a soft edge on a few triangles, for 160 x 120 pixels in 16 bits, dithered for RGB565."
            }
            Self::Turntable => "Eight moving spots with a soft edge, and highlights on everything.",
        }
    }

    /// Returns the width and the height in pixels for which the picture is composed. Another size
    /// with the same aspect ratio shows the same view.
    pub const fn size(self) -> (usize, usize) {
        match self {
            Self::Pocket => (160, 120),
            _ => (960, 540),
        }
    }

    /// Returns the example with this [`name`](Self::name).
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|example| example.name() == name)
    }

    /// Builds the scene and its fixtures.
    ///
    /// # Errors
    /// Never: the values are constants.
    pub fn setup(self) -> Result<Setup, Error> {
        match self {
            Self::BareSpot => bare_spot::setup(),
            Self::ThreePoint => three_point::setup(),
            Self::Grid => grid::narrow(),
            Self::WideGrid => grid::wide(),
            Self::Gallery => gallery::setup(),
            Self::Show => show::setup(),
            Self::Pocket => pocket::setup(),
            Self::Turntable => turntable(8),
        }
    }
}

impl Setup {
    fn new(scene: Scene, camera: Camera, fixtures: Vec<MovingLight>) -> Self {
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

    /// Returns the effects that the picture needs at a time in seconds.
    ///
    /// # Errors
    /// The same errors as [`fixtures_at`](Self::fixtures_at).
    pub fn effects_at(&self, seconds: f32) -> Result<Effects, Error> {
        let fixtures = self.fixtures_at(seconds)?;
        let mut plan = self.scene.plan();
        if self.display.is_dithered() {
            plan = plan.with(Effect::Dither);
        }
        Ok(fixtures.iter().fold(plan, |plan, fixture| plan.with_fixture(fixture)).effects())
    }

    /// Returns the camera at a time in seconds, for optional camera motion. In most scenes the
    /// camera stands still.
    pub fn camera_at(&self, seconds: f32) -> Camera {
        let mut camera = self.camera;
        camera.orbit(self.swing * Vec2::from_angle(TAU * seconds / SWING_PERIOD).y, 0.0);
        camera
    }
}
