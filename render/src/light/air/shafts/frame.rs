//! The directions of a beam in coordinates of the eye and the light.

use crate::{light::air::hazy::Hazy, space::vector};
use glam::Vec3;

/// The directions of a beam, as seen from the light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// The direction to the eye.
    pub(super) eye: Vec3,
    /// The direction orthogonal to `eye` on whose side the axis is, and the one orthogonal to both.
    pub(super) toward: Vec3,
    pub(super) beside: Vec3,
    /// The distance of the eye.
    pub(super) distance: f32,
    /// The coordinates of the axis along `eye` and along `toward`.
    pub(super) axis: [f32; 2],
    /// The versine and the sine of the outer angle.
    pub(super) versine: f32,
    pub(super) sine: f32,
}

/// Sine of the angle between the axis and the line from the light to the eye, relative to the sine of
/// the outer angle, up to which the eye counts as in the cone or in the opposite cone.
const OUTSIDE: f32 = 1.01;

impl Frame {
    /// Returns the frame of a beam; `None` if the eye is in the cone, in the opposite cone or in the
    /// light.
    pub(super) fn new(hazy: &Hazy, eye: Vec3) -> Option<Self> {
        let offset = eye - hazy.position;
        let (distance, eye) = (vector::length(offset), vector::direction(offset));
        let along = eye.dot(hazy.axis);
        let across = hazy.axis - along * eye;
        let aside = vector::length(across);
        let versine = hazy.beam.outer_versine();
        let sine = vector::sqrt(versine * (2.0 - versine));
        if !(distance > hazy.radius && versine < 1.0 && aside > OUTSIDE * sine) {
            return None;
        }
        let toward = across / aside;
        let beside = eye.cross(toward);
        Some(Self { eye, toward, beside, distance, axis: [along, aside], versine, sine })
    }

    /// Returns the coordinates of a vector.
    pub(super) fn local(&self, way: Vec3) -> Vec3 {
        Vec3::new(way.dot(self.toward), way.dot(self.beside), way.dot(self.eye))
    }
}
