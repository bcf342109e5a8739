//! What unit vectors are surely within, so that highlights that no eye sees are left out.

use crate::{
    bounds::Bounds,
    ways::{direction, direction_and_reciprocal, length},
};
use core::f32::consts::SQRT_2;
use glam::Vec3;

/// A sphere around directions: unit vectors that are nearly the same.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Directions {
    center: Vec3,
    radius: f32,
}

/// By how much more than touching directions are apart for certain, in every number format: none has light of a highlight more
/// than 1e-7 beyond its lobe (searched).
const MARGIN: f32 = 1.0 / 256.0;

impl Directions {
    /// One direction.
    pub(crate) fn new(direction: Vec3) -> Self {
        Self { center: direction, radius: 0.0 }
    }

    /// The directions in a box.
    pub(crate) fn between(least: Vec3, most: Vec3) -> Self {
        Self { center: 0.5 * (least + most), radius: 0.5 * length(most - least) }
    }

    /// The directions to a place from points; nothing where the place may be among them.
    #[inline(always)]
    pub(crate) fn towards(place: Vec3, points: &Bounds) -> Option<Self> {
        let way = place - points.center;
        let (direction, reciprocal) = direction_and_reciprocal(way);
        // A sphere is seen within an angle of this sine: the chord of an angle under 90 degrees is at most the square
        // root of two times its sine.
        let sine = points.padded(way) * reciprocal;
        (reciprocal > 0.0 && sine < 1.0).then_some(Self { center: direction, radius: SQRT_2 * sine })
    }

    /// The directions mirrored in surfaces of these normals.
    #[inline(always)]
    pub(crate) fn mirrored(&self, normals: &Self) -> Self {
        let normal = direction(normals.center);
        // A normal turns what is mirrored in it by twice its own angle.
        let turned = 2.0 * (normals.radius + length(normal - normals.center));
        let center = 2.0 * self.center.dot(normal) * normal - self.center;
        Self { center, radius: self.radius + turned }
    }

    /// The most that the product of any of these directions with a vector may be, by each component of it as much too much as
    /// the directions are apart.
    #[inline(always)]
    pub(crate) fn most_along(&self, vector: Vec3) -> f32 {
        self.center.dot(vector) + self.radius * vector.abs().element_sum()
    }

    /// Whether every one of these directions and every one of others are farther apart than a chord for certain.
    #[inline(always)]
    pub(crate) fn are_apart(&self, others: &Self, chord: f32) -> bool {
        let reach = chord + self.radius + others.radius + MARGIN;
        self.center.distance_squared(others.center) > reach * reach
    }
}

#[cfg(test)]
mod tests;
