//! View rays as a structure of arrays.

use super::ViewRay;
use crate::vec3::{Vec3, nth};

/// View rays from one eye, each quantity in its own array: see [`ViewRay`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ViewRays<const N: usize> {
    /// The position of the eye.
    pub eye: Vec3<f32>,
    /// The directions of view, of unit length.
    pub direction: Vec3<[f32; N]>,
    /// The distances to the surfaces; infinity for a ray that meets no surface.
    pub length: [f32; N],
}

impl<const N: usize> ViewRays<N> {
    /// Returns one of the rays; a ray of length 0 if `i` is out of bounds.
    #[inline]
    pub fn at(&self, i: usize) -> ViewRay {
        let Vec3 { x, y, z } = &self.direction;
        let direction = Vec3::new(nth(x, i), nth(y, i), nth(z, i));
        ViewRay { eye: self.eye, direction, length: nth(&self.length, i) }
    }
}
