//! Solids of revolution for still lifes.

use crate::{Mesh, Outline};
use core::f32::consts::{FRAC_PI_2, PI, TAU};

/// Number of segments around the axis, and number of lines in a quarter circle of an outline.
const AROUND: usize = 56;
pub(crate) const QUARTER: usize = 7;

/// Creates a sphere that stands on y = 0.
pub(crate) fn sphere(radius: f32) -> Mesh {
    Mesh::lathe(&Outline::start(0.0, 0.0).arc(0.0, radius, PI, 4 * QUARTER), AROUND)
}

/// Creates a torus that lies on y = 0. `core` is the radius of its core circle, `body` the radius
/// of its tube.
pub(crate) fn torus(core: f32, body: f32) -> Mesh {
    Mesh::lathe(&Outline::start(core, 0.0).arc(core, body, TAU, 4 * QUARTER), AROUND)
}

/// Creates a cone that stands on y = 0.
pub(crate) fn cone(radius: f32, height: f32) -> Mesh {
    Mesh::lathe(&Outline::start(0.0, 0.0).line_to(radius, 0.0).line_to(0.0, height), AROUND)
}

/// Creates a capsule around the y axis with its centre at the origin. `length` is the length of the
/// cylinder between the half spheres.
pub(crate) fn capsule(radius: f32, length: f32) -> Mesh {
    let half = length / 2.0;
    let outline = Outline::start(0.0, -half - radius)
        .arc(0.0, -half, FRAC_PI_2, QUARTER)
        .line_to(radius, half)
        .arc(0.0, half, FRAC_PI_2, QUARTER);
    Mesh::lathe(&outline, AROUND)
}

/// Creates a hollow vase with a lip.
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

/// Creates a column with base and capital.
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
