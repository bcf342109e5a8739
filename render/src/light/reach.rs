//! Bounds of light, used to skip points that no light reaches.

use glam::{Vec2, Vec3};
use luminaire::{Angle, dynamic::AnyLight};

use crate::space::{bounds::Bounds, directions::Directions};

/// Bounds of a light: no light arrives outside them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    source: Source,
    /// The range of the light; `None` for a light without a range.
    range: Option<f32>,
    beam: Option<Beam>,
}

/// Position of a light, or direction to the light.
#[derive(Clone, Copy, Debug)]
enum Source {
    Place(Vec3),
    /// Direction to an infinitely distant light.
    Direction(Vec3),
}

/// Cone that encloses the light of a spotlight.
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
            AnyLight::Measured(light) => {
                let beam = light.outer().map(|outer| Beam::new(light.frame()[2], outer));
                let source = Source::Place(light.position().into());
                Self { source, range: light.attenuation().range(), beam }
            }
            AnyLight::Spot(spot) => {
                let beam = Beam::new(spot.axis(), spot.cone().outer());
                Self {
                    source: Source::Place(spot.position().into()),
                    range: spot.attenuation().range(),
                    beam: Some(beam),
                }
            }
        }
    }

    /// Returns true only if, in every number format, no light reaches any point within the bounds.
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

    /// Returns true only if all surfaces with these bounds and normals face away from the light.
    ///
    /// The result holds in every number format.
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

    /// Returns the directions from the points within the bounds to the light.
    ///
    /// Returns `None` if the light may be inside the bounds.
    pub(crate) fn directions_from(&self, bounds: &Bounds) -> Option<Directions> {
        match self.source {
            Source::Direction(direction) => Some(Directions::new(direction)),
            Source::Place(place) => Directions::towards(place, bounds),
        }
    }
}

impl Beam {
    /// Creates a cone of a full angle.
    fn new(axis: luminaire::Vec3<f32>, outer: Angle) -> Self {
        Self { axis: axis.into(), edge: Vec2::from_angle(outer.to_radians() / 2.0) }
    }

    /// Returns whether a sphere is outside the cone. `way` is the vector from the light to the
    /// sphere's centre.
    fn misses(&self, way: Vec3, radius: f32) -> bool {
        // The distance to the cone is |way x axis| cos - (way . axis) sin, with the outer half
        // angle. The code compares squares instead of computing a square root.
        let inner = way.dot(self.axis) * self.edge.y + radius;
        let across = way.cross(self.axis);
        inner < 0.0 || across.dot(across) * self.edge.x * self.edge.x > inner * inner
    }
}
