//! What points and the light of a lamp are surely within, so that points that no light reaches are left out.

use glam::{Vec2, Vec3};
use luminaire::Lamp;

/// A sphere around points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    pub(crate) center: Vec3,
    pub(crate) radius: f32,
}

/// What the light of a lamp is within.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    /// Nothing for light from infinitely far away.
    position: Option<Vec3>,
    /// Nothing where there is no range.
    range: Option<f32>,
    beam: Option<Beam>,
}

/// What a spotlight's cone is within.
#[derive(Clone, Copy, Debug)]
struct Beam {
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

    /// A sphere around spheres; nothing if there are none.
    pub(crate) fn enclosing(spheres: impl Iterator<Item = Self> + Clone) -> Option<Self> {
        let (sum, count) = spheres.clone().fold((Vec3::ZERO, 0.0), |(sum, n), s| (sum + s.center, n + 1.0));
        let center = sum / count;
        let reach = |sphere: Self| center.distance(sphere.center) + sphere.radius;
        // Not a number, and so no sphere, without any.
        (count > 0.0).then(|| Self { center, radius: spheres.map(reach).fold(0.0, f32::max) })
    }
}

impl Reach {
    pub(crate) fn new(lamp: &Lamp) -> Self {
        match lamp {
            Lamp::Directional(_) => Self { position: None, range: None, beam: None },
            Lamp::Point(point) => Self {
                position: Some(point.position().into()),
                range: point.attenuation().range(),
                beam: None,
            },
            Lamp::Spot(spot) => {
                let outer = spot.cone().outer().to_radians();
                let beam = Beam { axis: spot.axis().into(), edge: Vec2::from_angle(outer / 2.0) };
                Self {
                    position: Some(spot.position().into()),
                    range: spot.attenuation().range(),
                    beam: Some(beam),
                }
            }
        }
    }

    /// Whether the bounds are out of reach for certain, in every number format: by a thousandth of the distance and a
    /// tenth of a millimetre more than touching. The formats' directions are off by 1.6e-5 at most, and their positions
    /// by 8e-6 metres.
    pub(crate) fn misses(&self, bounds: &Bounds) -> bool {
        let Some(position) = self.position else { return false };
        let way = bounds.center - position;
        let margin = 1e-3 * (way.abs().element_sum() + bounds.center.abs().element_sum()) + 1e-4;
        let padded = bounds.radius + margin;
        let is_beyond = self.range.is_some_and(|range| {
            let reach = range + padded;
            way.length_squared() > reach * reach
        });
        is_beyond || self.beam.is_some_and(|beam| beam.misses(way, padded))
    }
}

impl Beam {
    /// Whether a sphere of this radius at the end of this way from the lamp is outside the cone.
    fn misses(&self, way: Vec3, radius: f32) -> bool {
        // The distance to the cone is |way x axis| cos - (way . axis) sin: compared by squares.
        let inner = way.dot(self.axis) * self.edge.y + radius;
        let across = way.cross(self.axis);
        inner < 0.0 || across.dot(across) * self.edge.x * self.edge.x > inner * inner
    }
}
