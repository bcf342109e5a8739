//! Bounding spheres of unit vectors, used to skip highlights that cannot reach the eye.

use crate::space::{
    bounds::Bounds,
    vector::{direction, direction_and_reciprocal, length},
};
use core::f32::consts::SQRT_2;
use glam::Vec3;

/// A sphere around unit vectors that are nearly parallel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Directions {
    center: Vec3,
    radius: f32,
}

/// Distance added in [`Directions::are_apart`]. In every number format, the light of a highlight
/// ends at most a chord of 1e-7 beyond its lobe (searched).
const MARGIN: f32 = 1.0 / 256.0;

impl Directions {
    /// Returns a sphere around one direction.
    pub(crate) fn new(direction: Vec3) -> Self {
        Self { center: direction, radius: 0.0 }
    }

    /// Encloses all directions whose components are between the components of two corners of a box.
    pub(crate) fn between(least: Vec3, most: Vec3) -> Self {
        Self { center: 0.5 * (least + most), radius: 0.5 * length(most - least) }
    }

    /// Encloses the directions from the points within bounds to a position; `None` if the position
    /// may be among the points.
    #[inline(always)]
    pub(crate) fn towards(place: Vec3, points: &Bounds) -> Option<Self> {
        let way = place - points.center;
        let (direction, reciprocal) = direction_and_reciprocal(way);
        // `sine` is the sine of the half angle under which the sphere is seen. The chord of an
        // angle under 90 degrees is at most `sqrt(2)` times its sine.
        let sine = points.padded(way) * reciprocal;
        (reciprocal > 0.0 && sine < 1.0).then_some(Self { center: direction, radius: SQRT_2 * sine })
    }

    /// Encloses the directions after mirroring in surfaces with these normals.
    #[inline(always)]
    pub(crate) fn mirrored(&self, normals: &Self) -> Self {
        let normal = direction(normals.center);
        // Rotating a normal rotates the mirrored direction by twice the angle.
        let turned = 2.0 * (normals.radius + length(normal - normals.center));
        let center = 2.0 * self.center.dot(normal) * normal - self.center;
        Self { center, radius: self.radius + turned }
    }

    /// Returns an upper bound of `dot(d, vector)` over all directions `d` within this bounding sphere.
    ///
    /// The bound is `dot(center, vector) + radius * |vector|_1`. The bound is not tight, because
    /// the 1-norm of `vector` is larger than its length.
    #[inline(always)]
    pub(crate) fn most_along(&self, vector: Vec3) -> f32 {
        self.center.dot(vector) + self.radius * vector.abs().element_sum()
    }

    /// Returns true only if every direction of this sphere is farther than `chord` from every
    /// direction of `others`.
    #[inline(always)]
    pub(crate) fn are_apart(&self, others: &Self, chord: f32) -> bool {
        let reach = chord + self.radius + others.radius + MARGIN;
        self.center.distance_squared(others.center) > reach * reach
    }
}

#[cfg(test)]
mod tests;
