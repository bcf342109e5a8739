//! Scenes that differ in what they call for: from one bare spotlight to a house full of lights.
//!
//! ```
//! use luminaire_render::{Renderer, examples::Example};
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
mod grid;
mod pocket;
mod room;
mod show;
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

/// A scene to learn from.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Example {
    /// One soft spotlight on a vase.
    BareSpot,
    /// Key, fill and back light on a still life.
    ThreePoint,
    /// A floor under 64 narrow spotlights.
    Grid,
    /// The same floor under 8 wide spotlights that light as much of it.
    WideGrid,
    /// Pictures and sculptures in the light of many kinds of lights.
    Gallery,
    /// Moving heads in a dark house.
    Show,
    /// A still life for the display of a microcontroller.
    Pocket,
    /// Four solids that shine under eight spotlights, all of which move.
    Turntable,
}

/// What stands in a scene, who looks at it, and what hangs above it.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub struct Setup {
    /// What stands there, and the ambient light.
    pub scene: Scene,
    /// The camera at second 0.
    pub camera: Camera,
    /// The fixtures, with their names and movements.
    pub fixtures: Vec<MovingLight>,
    /// What the picture is shown on.
    pub display: Display,
    /// How far to either side the camera swings, in radians.
    swing: f32,
}

/// How long the camera takes to swing to one side, to the other and back, in seconds.
const SWING_PERIOD: f32 = 24.0;

impl Example {
    /// All examples, those that call for less first.
    pub const ALL: [Self; 8] = [
        Self::BareSpot,
        Self::Pocket,
        Self::ThreePoint,
        Self::Grid,
        Self::WideGrid,
        Self::Turntable,
        Self::Show,
        Self::Gallery,
    ];

    /// The name: one word, or words joined by hyphens, for files and addresses.
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

    /// The title.
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

    /// What the scene calls for, in a sentence.
    pub const fn summary(self) -> &'static str {
        match self {
            Self::BareSpot => {
                "One spot with a soft edge on matt surfaces, and nothing else: no ambient light."
            }
            Self::ThreePoint => {
                "Key, fill and back light with the edges that two angles of a data sheet ask for, ambient light, and two shadows."
            }
            Self::Grid => "64 narrow spots with a soft edge: each lights a sixty-fourth of the floor.",
            Self::WideGrid => "8 wide spots with a soft edge, which light as many square metres as the 64.",
            Self::Gallery => {
                "26 lights of every kind, profile and distance model, and highlights on the few things that shine."
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

    /// Width and height in pixels that the picture is composed for. Larger and smaller ones of the same shape show the same.
    pub const fn size(self) -> (usize, usize) {
        match self {
            Self::Pocket => (160, 120),
            _ => (960, 540),
        }
    }

    /// The example of a [`name`](Self::name).
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|example| example.name() == name)
    }

    /// Builds the scene, and hangs its fixtures.
    ///
    /// # Errors
    /// None, unless a constructor comes to refuse what it accepts today.
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

    /// The fixtures after so many seconds, in the order of [`fixtures`](Self::fixtures). The same seconds always give the same.
    ///
    /// # Errors
    /// Seconds that are not finite, where something moves.
    pub fn fixtures_at(&self, seconds: f32) -> Result<Vec<Fixture>, Error> {
        self.fixtures.iter().map(|fixture| fixture.at(seconds)).collect()
    }

    /// What a picture calls for after so many seconds.
    ///
    /// # Errors
    /// As [`fixtures_at`](Self::fixtures_at).
    pub fn effects_at(&self, seconds: f32) -> Result<Effects, Error> {
        let fixtures = self.fixtures_at(seconds)?;
        let mut plan = self.scene.plan();
        if self.display.is_dithered() {
            plan = plan.with(Effect::Dither);
        }
        Ok(fixtures.iter().fold(plan, |plan, fixture| plan.with_fixture(fixture)).effects())
    }

    /// The camera after so many seconds, for who wants it to move: in most scenes it stands still.
    pub fn camera_at(&self, seconds: f32) -> Camera {
        let mut camera = self.camera;
        camera.orbit(self.swing * Vec2::from_angle(TAU * seconds / SWING_PERIOD).y, 0.0);
        camera
    }
}
