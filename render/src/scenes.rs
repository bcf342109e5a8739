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
mod setup;
mod show;
pub(crate) mod solids;
pub mod stage;
mod three_point;
pub mod tree;
mod turntable;

pub use self::{fixture::MovingLight, setup::Setup, turntable::turntable};

use crate::{Display, Output};
use luminaire::Error;

/// An example scene.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Example {
    /// One soft spotlight on a vase.
    BareSpot,
    /// Key, fill and back light on a still life.
    ThreePoint,
    /// A floor under 64 narrow spotlights.
    Grid,
    /// Pictures and sculptures in the light of many kinds of lights.
    Gallery,
    /// Moving heads in a dark theatre.
    Show,
    /// A still life for the display of a microcontroller.
    Pocket,
    /// 500 LEDs on a tree, under moving spotlights.
    Tree,
    /// Four shiny solids under eight spotlights, which all move.
    Turntable,
}

impl Example {
    /// All examples, ordered by the number of effects that they need, fewest first.
    pub const ALL: &[Self] = &[
        Self::BareSpot,
        Self::Pocket,
        Self::Tree,
        Self::ThreePoint,
        Self::Grid,
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
            Self::Gallery => "gallery",
            Self::Show => "show",
            Self::Pocket => "pocket",
            Self::Tree => "tree",
            Self::Turntable => "turntable",
        }
    }

    /// Returns the title.
    pub const fn title(self) -> &'static str {
        match self {
            Self::BareSpot => "One bare spot",
            Self::ThreePoint => "Three-point lighting",
            Self::Grid => "A grid of 64 spots",
            Self::Gallery => "A gallery",
            Self::Show => "A show",
            Self::Pocket => "A pocket display",
            Self::Tree => "A tree of LEDs",
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
            Self::Gallery => {
                "26 lights of every kind, falloff and distance model, and highlights on the few things that shine."
            }
            Self::Show => {
                "Moving heads with coloured beams in haze, soft and hard, and two turning gobos, in a house without ambient light."
            }
            Self::Pocket => {
                "One spot with a soft edge on a few triangles, for 160 x 120 pixels of any display: each square is one pixel."
            }
            Self::Tree => {
                "500 LEDs of a strip, each lit by four moving spots: they show the bytes of the strip, within a limit of its current."
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

    /// Returns the display for which the picture is composed.
    pub const fn display(self) -> Display {
        match self {
            Self::Pocket => Output::Rgb565.dithered(),
            _ => Output::Rgb888.nearest(),
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
        let setup = match self {
            Self::BareSpot => bare_spot::setup(),
            Self::ThreePoint => three_point::setup(),
            Self::Grid => grid::setup(),
            Self::Gallery => gallery::setup(),
            Self::Show => show::setup(),
            Self::Pocket => pocket::setup(),
            Self::Tree => tree::setup(),
            Self::Turntable => turntable(8),
        }?;
        Ok(Setup { display: self.display(), ..setup })
    }
}
