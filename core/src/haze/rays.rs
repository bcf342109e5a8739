//! View rays, many at once.

use super::ViewRay;
use crate::vec3::{Vec3, nth};

/// View rays from one eye, each quantity in an array of its own: see [`ViewRay`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ViewRays<const N: usize> {
    /// Where the eye is.
    pub eye: Vec3<f32>,
    /// Where it looks, of unit length.
    pub direction: Vec3<[f32; N]>,
    /// How far it sees; infinity where there is no surface.
    pub length: [f32; N],
}

impl<const N: usize> ViewRays<N> {
    /// One of the rays; beyond the last a ray of no length.
    #[inline]
    pub fn at(&self, i: usize) -> ViewRay {
        let Vec3 { x, y, z } = &self.direction;
        let direction = Vec3::new(nth(x, i), nth(y, i), nth(z, i));
        ViewRay { eye: self.eye, direction, length: nth(&self.length, i) }
    }
}
