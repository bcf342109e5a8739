//! Bounding spheres of points.

use glam::Vec3;

use crate::space::vector::length;

/// A sphere around points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    pub(crate) center: Vec3,
    pub(crate) radius: f32,
}

impl Bounds {
    /// Returns a bounding sphere around the centre of the points' bounding box.
    pub(crate) fn of(points: impl Iterator<Item = Vec3> + Clone) -> Self {
        let center = 0.5
            * (points.clone().fold(Vec3::INFINITY, Vec3::min)
                + points.clone().fold(-Vec3::INFINITY, Vec3::max));
        Self { center, radius: points.map(|point| length(point - center)).fold(0.0, f32::max) }
    }

    /// Returns a bounding sphere of four points. The sphere also encloses the convex hull of the
    /// points.
    #[inline(always)]
    pub(crate) fn around(points: [Vec3; 4]) -> Self {
        let center = 0.25 * points.into_iter().sum::<Vec3>();
        let ways = points.map(|point| point - center);
        let farther = |a: Vec3, b: Vec3| if b.length_squared() > a.length_squared() { b } else { a };
        Self { center, radius: length(ways.into_iter().fold(Vec3::ZERO, farther)) }
    }

    /// Returns the radius of a sphere that encloses the points in every number format.
    ///
    /// `way` is a vector from or to the sphere's centre. The radius is increased by at least 1/5000
    /// of the length of `way`, and by 0.1 mm. This increase is more than the errors of the formats:
    /// less than 2^-15 for a direction, and half a step, 2^-17, for a position.
    pub(crate) fn padded(&self, way: Vec3) -> f32 {
        self.radius + 2e-4 * (way.abs().element_sum() + self.center.abs().element_sum()) + 1e-4
    }

    /// Returns a sphere that encloses all the given spheres; `None` without spheres.
    pub(crate) fn enclosing(spheres: impl Iterator<Item = Self> + Clone) -> Option<Self> {
        let (sum, count) = spheres.clone().fold((Vec3::ZERO, 0.0), |(sum, n), s| (sum + s.center, n + 1.0));
        let center = sum / count;
        let reach = |sphere: Self| length(center - sphere.center) + sphere.radius;
        // Without spheres the centre is NaN.
        (count > 0.0).then(|| Self { center, radius: spheres.map(reach).fold(0.0, f32::max) })
    }
}
