//! What a block of points and a beam of light are surely within, so that a block no light reaches is left
//! out.

use glam::{Vec2, Vec3};
use luminaire::Spot;

/// A sphere around points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    pub(crate) center: Vec3,
    pub(crate) radius: f32,
}

/// What a spotlight's cone is within.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beam {
    position: Vec3,
    axis: Vec3,
    /// Cosine and sine of the outer half angle.
    edge: Vec2,
}

impl Bounds {
    /// A sphere around points: that of their box's middle.
    pub(crate) fn of(points: impl Iterator<Item = Vec3> + Clone) -> Self {
        let center = 0.5
            * (points.clone().fold(Vec3::INFINITY, Vec3::min)
                + points.clone().fold(-Vec3::INFINITY, Vec3::max));
        Self { center, radius: points.map(|point| point.distance(center)).fold(0.0, f32::max) }
    }

    /// A sphere around the convex hull of four points.
    #[inline(always)]
    pub(crate) fn around(points: [Vec3; 4]) -> Self {
        let center = 0.25 * points.into_iter().sum::<Vec3>();
        let ways = points.map(|point| point - center);
        let farther = |a: Vec3, b: Vec3| if b.length_squared() > a.length_squared() { b } else { a };
        Self { center, radius: ways.into_iter().fold(Vec3::ZERO, farther).length() }
    }
}

impl Beam {
    pub(crate) fn new(spot: &Spot) -> Self {
        let outer = spot.cone().outer().to_radians();
        Self {
            position: spot.position().into(),
            axis: spot.axis().into(),
            edge: Vec2::from_angle(outer / 2.0),
        }
    }

    /// Whether the bounds are outside the cone for certain, in every number format: by a thousandth of the
    /// distance and a tenth of a millimetre more than touching. The formats' directions are off by 1.2e-5 at
    /// most, and their positions by 8e-6 metres.
    pub(crate) fn misses(&self, bounds: &Bounds) -> bool {
        let way = bounds.center - self.position;
        let reach = way.abs().element_sum() + bounds.center.abs().element_sum();
        let margin = 1e-3 * reach + 1e-4;
        // The distance to the cone is |way x axis| cos - (way . axis) sin: compared by squares.
        let inner = way.dot(self.axis) * self.edge.y + bounds.radius + margin;
        let across = way.cross(self.axis);
        inner < 0.0 || across.dot(across) * self.edge.x * self.edge.x > inner * inner
    }
}
