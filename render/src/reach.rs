//! Bounds of light, so that points that no light reaches are left out.

use glam::{Vec2, Vec3};
use luminaire::dynamic::AnyLight;

use crate::{bounds::Bounds, directions::Directions};

/// Bounds of a light: it cannot reach what is outside of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    source: Source,
    /// Nothing where there is no range.
    range: Option<f32>,
    beam: Option<Beam>,
}

/// Where light comes from.
#[derive(Clone, Copy, Debug)]
enum Source {
    Place(Vec3),
    /// From infinitely far away, in this direction.
    Direction(Vec3),
}

/// What a spotlight's cone is within.
#[derive(Clone, Copy, Debug)]
struct Beam {
    axis: Vec3,
    /// Cosine and sine of the outer half angle.
    edge: Vec2,
}

impl Reach {
    pub(crate) fn new(light: &AnyLight) -> Self {
        match light {
            AnyLight::Directional(light) => {
                let direction = Vec3::from(light.direction());
                Self { source: Source::Direction(-direction), range: None, beam: None }
            }
            AnyLight::Point(point) => Self {
                source: Source::Place(point.position().into()),
                range: point.attenuation().range(),
                beam: None,
            },
            AnyLight::Spot(spot) => {
                let outer = spot.cone().outer().to_radians();
                let beam = Beam { axis: spot.axis().into(), edge: Vec2::from_angle(outer / 2.0) };
                Self {
                    source: Source::Place(spot.position().into()),
                    range: spot.attenuation().range(),
                    beam: Some(beam),
                }
            }
        }
    }

    /// Whether the bounds are out of reach for certain, in every number format.
    pub(crate) fn misses(&self, bounds: &Bounds) -> bool {
        let Source::Place(position) = self.source else { return false };
        let way = bounds.center - position;
        let padded = bounds.padded(way);
        let is_beyond = self.range.is_some_and(|range| {
            let reach = range + padded;
            way.length_squared() > reach * reach
        });
        is_beyond || self.beam.is_some_and(|beam| beam.misses(way, padded))
    }

    /// Whether surfaces within the bounds and with these normals face away from the light for certain, in every number
    /// format.
    #[inline(always)]
    pub(crate) fn is_behind(&self, bounds: &Bounds, normals: &Directions) -> bool {
        match self.source {
            Source::Direction(direction) => normals.most_along(direction) < -1e-3,
            Source::Place(position) => {
                let way = position - bounds.center;
                normals.most_along(way) < -(1e-3 * way.abs().element_sum() + bounds.padded(way))
            }
        }
    }

    /// The directions to the light from points within bounds; nothing where it may be among them.
    pub(crate) fn directions_from(&self, bounds: &Bounds) -> Option<Directions> {
        match self.source {
            Source::Direction(direction) => Some(Directions::new(direction)),
            Source::Place(place) => Directions::towards(place, bounds),
        }
    }
}

impl Beam {
    /// Whether a sphere of this radius at the end of this way from the light is outside the cone.
    fn misses(&self, way: Vec3, radius: f32) -> bool {
        // The distance to the cone is |way x axis| cos - (way . axis) sin: compared by squares.
        let inner = way.dot(self.axis) * self.edge.y + radius;
        let across = way.cross(self.axis);
        inner < 0.0 || across.dot(across) * self.edge.x * self.edge.x > inner * inner
    }
}
