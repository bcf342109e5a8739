//! Solids of revolution for still lifes.

use crate::{Mesh, Outline};
use core::f32::consts::{FRAC_PI_2, PI, TAU};

/// Number of segments around the axis, and number of lines in a quarter circle of an outline.
const AROUND: usize = 56;
pub(crate) const QUARTER: usize = 7;

/// A sphere that stands on y = 0.
pub(crate) fn sphere(radius: f32) -> Mesh {
    Mesh::lathe(&Outline::start(0.0, 0.0).arc(0.0, radius, PI, 4 * QUARTER), AROUND)
}

/// A torus that lies on y = 0, with the radius of its core circle and that of its tube.
pub(crate) fn torus(core: f32, body: f32) -> Mesh {
    Mesh::lathe(&Outline::start(core, 0.0).arc(core, body, TAU, 4 * QUARTER), AROUND)
}

/// A cone that stands on y = 0.
pub(crate) fn cone(radius: f32, height: f32) -> Mesh {
    Mesh::lathe(&Outline::start(0.0, 0.0).line_to(radius, 0.0).line_to(0.0, height), AROUND)
}

/// A capsule around the y axis with its centre at the origin: its radius, and the length of its
/// cylinder.
pub(crate) fn capsule(radius: f32, length: f32) -> Mesh {
    let half = length / 2.0;
    let outline = Outline::start(0.0, -half - radius)
        .arc(0.0, -half, FRAC_PI_2, QUARTER)
        .line_to(radius, half)
        .arc(0.0, half, FRAC_PI_2, QUARTER);
    Mesh::lathe(&outline, AROUND)
}

/// A vase with a lip, hollow.
pub(crate) fn vase() -> Mesh {
    let outline = Outline::start(0.0, 0.0)
        .line_to(0.15, 0.0)
        .line_to(0.16, 0.03)
        .curve_to([(0.2, 0.12), (0.33, 0.3)], 0.31, 0.5, 10)
        .curve_to([(0.29, 0.68), (0.09, 0.66)], 0.1, 0.84, 10)
        .curve_to([(0.105, 0.91), (0.14, 0.93)], 0.185, 0.94, 5)
        .line_to(0.17, 0.955)
        .curve_to([(0.12, 0.94), (0.085, 0.92)], 0.08, 0.84, 4)
        .line_to(0.0, 0.5);
    Mesh::lathe(&outline, AROUND)
}

/// A column with base and capital.
pub(crate) fn column() -> Mesh {
    let outline = Outline::start(0.0, 0.0)
        .line_to(0.32, 0.0)
        .line_to(0.32, 0.1)
        .line_to(0.26, 0.1)
        .arc(0.26, 0.15, PI, QUARTER)
        .line_to(0.21, 0.2)
        .curve_to([(0.205, 0.7), (0.195, 1.0)], 0.165, 1.3, 8)
        .line_to(0.19, 1.32)
        .arc(0.19, 1.345, PI, QUARTER)
        .curve_to([(0.19, 1.41), (0.23, 1.43)], 0.27, 1.45, 5)
        .line_to(0.27, 1.56)
        .line_to(0.0, 1.56);
    Mesh::lathe(&outline, AROUND)
}
