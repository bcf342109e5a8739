//! Meshes and lights that most scenes share: a floor, a wall and a spotlight that points at a
//! target.

use crate::{Mesh, Outline};
use core::f32::consts::FRAC_PI_2;
use luminaire::{Cone, Error, SpotLight, Vec3, falloff::Falloff};

/// Creates a floor around the origin, with this width and depth in metres.
pub(super) fn floor(width: f32, depth: f32) -> Mesh {
    let half = width / 2.0;
    let across = Outline::start(half, 0.0).line_to(-half, 0.0);
    Mesh::extrude(&across, depth, 1).moved(Vec3::new(0.0, 0.0, -depth / 2.0))
}

/// Creates a wall that stands on the floor, faces positive z and has its centre at x = 0.
pub(super) fn wall(width: f32, height: f32, z: f32) -> Mesh {
    floor(width, height).turned(Vec3::new(1.0, 0.0, 0.0), FRAC_PI_2).moved(Vec3::new(0.0, height / 2.0, z))
}

/// Creates a spotlight at a position that points at a target.
pub(super) fn aimed<P: Falloff>(
    position: Vec3<f32>,
    target: Vec3<f32>,
    cone: Cone<P>,
) -> Result<SpotLight<P>, Error> {
    SpotLight::new(position, target.zip(position, |t, p| t - p), cone)
}
