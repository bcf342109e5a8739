//! A view ray as seen from the light: an arc of directions.

use super::{ViewRay, polynomial::OnArc};
use crate::{number::float::positive, trig, vec3::Vec3};

/// Extent of a beam: the light's position and axis, and the squares of its radius and range.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub(super) position: Vec3<f32>,
    pub(super) axis: Vec3<f32>,
    pub(super) radius_squared: f32,
    pub(super) reach_squared: f32,
}

/// The part of a view ray between the light's body and its range, as an arc of directions.
///
/// The arc lies on a great circle. A direction on the circle is given by `v = tan(psi/2)`, where
/// `psi` is the angle of that direction from the circle's direction nearest to the axis of the
/// light. A point of the ray is given by its coordinate along the ray, measured from the foot. The
/// foot is the point of the ray's line that is nearest to the light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    direction: Vec3<f32>,
    /// The vector from the light to the foot, its length, and the reciprocal of its length.
    foot: Vec3<f32>,
    height: f32,
    reciprocal: f32,
    /// The cosines of two angles: between the axis and the direction to the foot, between the axis
    /// and the ray.
    across: f32,
    along: f32,
    /// The cosine and the versine of the angle between the axis and the great circle.
    radius: f32,
    least: f32,
    /// The coordinates of the two ends on the ray.
    first: f32,
    last: f32,
}

/// The part of an arc within a cone, as limits of `v`, and the factor of an integral over `v`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) from: f32,
    pub(super) to: f32,
    pub(super) scale: f32,
}

/// Squared distance, in squared light radii, below which a line counts as passing through the
/// light.
///
/// Such a line passes through the light's body. Outside the body, all points of the line lie in the
/// direction of the ray or opposite to it, as seen from the light, within f32 precision.
const THROUGH: f32 = 1e-14;

/// Arc length in `v` below which the scale is computed from the length along the ray.
///
/// In a shorter arc, the difference of the two values of `v` would have too few correct bits.
const SHORT: f32 = 1.0 / 16.0;

/// Shortest length of an arc in `v`, relative to the `v` of the cone's edge.
///
/// A shorter arc is lengthened to this length, and its scale is reduced in proportion. So the
/// integral stays right if both ends of the arc round to the same value.
const SHORTEST: f32 = 1.0 / 262_144.0;

/// Finite replacement for the tangent of a right angle: `v` opposite the axis.
const OPPOSITE: f32 = 1e6;

impl Arc {
    /// Computes the arc of a view ray.
    #[inline(always)] // Turntable in haze on x86-64: 2.2 times the instructions without.
    pub(super) fn new(extent: &Extent, view: &ViewRay) -> Self {
        let Extent { position, axis, radius_squared, reach_squared } = *extent;
        let direction = view.direction;
        let eye = view.eye.zip(position, |e, p| e - p);
        // Orthogonalises twice. The first step leaves a rounding error along the ray, and this
        // error may be longer than a short vector to the foot.
        let back = eye.dot(direction);
        let nearly = eye.zip(direction, |e, d| e - back * d);
        let rest = nearly.dot(direction);
        let foot = nearly.zip(direction, |n, d| n - rest * d);
        let start = back + rest;

        let squared = foot.dot(foot);
        let is_through = squared < THROUGH * radius_squared;
        let squared = if is_through { THROUGH * radius_squared } else { squared };
        let reciprocal = trig::inverse_sqrt(squared);
        let height = squared * reciprocal;
        // If the line passes through the light, the vector to the foot is zero or nearly zero. Any
        // direction orthogonal to the line may then replace the direction to the foot. `normal` is
        // also orthogonal to the axis.
        let normal = direction.cross(axis);
        let sine = foot.dot(normal) * reciprocal;
        let squared_sine = if is_through { normal.dot(normal) } else { sine * sine };
        let across = if is_through { 0.0 } else { foot.dot(axis) * reciprocal };
        let along = direction.dot(axis);
        // Computed from `sine`, the cosine `radius` would lose all bits if the great circle is
        // nearly orthogonal to the axis.
        let radius = trig::sqrt(across * across + along * along);

        let [first, last] = lit(squared, radius_squared, reach_squared, [start, start + view.length]);
        let least = squared_sine / (1.0 + radius);
        Self { direction, foot, height, reciprocal, across, along, radius, least, first, last }
    }

    /// Returns whether any part of the ray lies between the light's body and its range.
    #[inline]
    pub(super) fn is_any(&self) -> bool {
        self.first < self.last
    }

    /// Returns the `v` at which the great circle leaves a cone; zero if the circle does not meet
    /// the cone.
    #[inline]
    pub(super) fn edge(&self, versine: f32) -> f32 {
        trig::sqrt(positive((versine - self.least) / ((1.0 - versine) + self.radius)))
    }

    /// Returns the part of the arc where the absolute value of `v` is at most an
    /// [`edge`](Self::edge).
    ///
    /// The edge is at most 1.
    ///
    /// The span is empty unless `from < to`.
    #[inline(always)] // Turntable in haze on x86-64: +1.9 % without.
    pub(super) fn span(&self, edge: f32) -> Span {
        let (near, far) = (self.distance(self.first), self.distance(self.last));
        let (from, to) = (self.toward(self.first, near), self.toward(self.last, far));
        let length = to - from;
        // `v` increases along a ray, except where the arc passes the point of its circle opposite
        // the axis. In that case `from` is positive and `to` is negative. These signs are reliable:
        // the sign of `v` is the sign of a sine that is monotone in the coordinate, even after
        // rounding. Near that point, the difference `to - from` may consist of rounding errors
        // only. Such an arc contains at most one edge of the cone, because the arc is shorter than
        // a half circle.
        let is_around = from > 0.0 && to < 0.0;
        let is_short = length < SHORT && !is_around;
        // `worth` is `(to - from) / height`, computed without the difference `to - from`.
        let way = (self.last - self.first) * ((1.0 + from * from) * (1.0 + to * to));
        let worth = way / (2.0 * (1.0 + from * to) * (near * far));
        let shortest = SHORTEST * edge;
        let kept = if length > shortest { length } else { shortest };
        let begin = if is_short { to - kept } else { from };
        // Divides by the length from the rounded `begin`.
        let scale = if is_short { worth / (to - begin) } else { self.reciprocal };
        let comes_in_last = is_around && from >= edge;
        let begin = if comes_in_last || begin < -edge { -edge } else { begin };
        let end = if (is_around && from < edge) || to > edge { edge } else { to };
        Span { from: begin, to: end, scale }
    }

    /// Returns the versine of the angle between the axis and the direction `v` on the circle.
    ///
    /// `share` is `1 / (1 + v^2)`.
    #[inline]
    pub(super) fn versine(&self, v: f32, share: f32) -> f32 {
        self.least + 2.0 * self.radius * (v * v) * share
    }

    /// Returns a polynomial falloff on this arc, for `t = (outer - versine) * reciprocal`.
    #[inline]
    pub(super) fn with(&self, curve: [f32; 3], outer: f32, reciprocal: f32) -> OnArc {
        OnArc { curve, top: (outer - self.least) * reciprocal, slope: 2.0 * self.radius * reciprocal }
    }

    /// Returns the coordinates at which the ray enters and leaves a cone of this
    /// [`edge`](Self::edge).
    ///
    /// If the ray misses the cone, both results are the same coordinate: the end of the ray, or the
    /// coordinate nearest to the axis.
    #[inline]
    pub(super) fn between(&self, edge: f32) -> [f32; 2] {
        let (cosine, sine) = (1.0 - edge * edge, 2.0 * edge);
        // The cosines of the angles between the direction to the foot and the two edges of the
        // cone, up to a factor. If the cosine for an edge is at most 0, the line does not reach
        // that edge.
        let lower = cosine * self.across + sine * self.along;
        let upper = cosine * self.across - sine * self.along;
        let from = self.inside(self.height * (cosine * self.along - sine * self.across) / lower);
        let to = self.inside(self.height * (cosine * self.along + sine * self.across) / upper);
        let is_missed = (lower < 0.0 && upper < 0.0) || (edge <= 0.0 && self.across <= 0.0);
        let from = if lower > 0.0 { from } else { self.first };
        [if is_missed { self.last } else { from }, if upper > 0.0 && !is_missed { to } else { self.last }]
    }

    /// Clamps a coordinate on the ray's line to the two ends of the arc.
    #[inline]
    fn inside(&self, place: f32) -> f32 {
        let place = if place > self.first { place } else { self.first };
        if place < self.last { place } else { self.last }
    }

    /// Returns the distance from the light at a coordinate on the ray.
    #[inline]
    pub(super) fn distance(&self, place: f32) -> f32 {
        trig::sqrt(self.height * self.height + place * place)
    }

    /// Returns `sin psi` and `1 + cos psi` at a coordinate, both times `distance * radius`.
    ///
    /// `psi` is the angle between the direction at this coordinate and the great circle's direction
    /// nearest to the axis.
    #[inline]
    fn turn(&self, place: f32, distance: f32) -> (f32, f32) {
        let sine = self.across * place - self.along * self.height;
        (sine, distance * self.radius + (self.across * self.height + self.along * place))
    }

    /// Returns `v` at a coordinate on the ray, at this distance from the light.
    #[inline]
    fn toward(&self, place: f32, distance: f32) -> f32 {
        let (sine, one_plus_cosine) = self.turn(place, distance);
        // Opposite the axis, `1 + cos psi` is zero within rounding errors, and `v` has no finite
        // value.
        let far = if sine < 0.0 { -OPPOSITE } else { OPPOSITE };
        if one_plus_cosine * OPPOSITE > distance { sine / one_plus_cosine } else { far }
    }

    /// Returns the versine of the angle off axis at a coordinate on the ray.
    ///
    /// `distance` is the distance of that point from the light. If the versine is over 1, the
    /// result is some value over 1.
    #[inline]
    pub(super) fn versine_at(&self, place: f32, distance: f32) -> f32 {
        let (sine, one_plus_cosine) = self.turn(place, distance);
        let is_ahead = one_plus_cosine > distance * self.radius;
        self.least + if is_ahead { sine * sine / (distance * one_plus_cosine) } else { 1.0 }
    }

    /// Returns the coordinate on the ray that lies in the direction `v`.
    #[inline]
    pub(super) fn place(&self, v: f32) -> f32 {
        let (cosine, sine) = (1.0 - v * v, 2.0 * v);
        let across = positive(cosine * self.across - sine * self.along);
        let along = self.height * (sine * self.across + cosine * self.along);
        self.inside(along / if across > f32::MIN_POSITIVE { across } else { f32::MIN_POSITIVE })
    }

    /// Returns the world position of a coordinate on the ray.
    #[inline]
    pub(super) fn point(&self, position: Vec3<f32>, place: f32) -> Vec3<f32> {
        position.zip(self.foot, |p, f| p + f).zip(self.direction, |p, d| p + place * d)
    }
}

/// Clips a ray to the part that is outside the light's body, not behind the body, and within range.
#[inline]
fn lit(squared: f32, radius_squared: f32, reach_squared: f32, [first, last]: [f32; 2]) -> [f32; 2] {
    let body = trig::sqrt(positive(radius_squared - squared));
    let is_inside = -body < first && first < body;
    let is_before = first <= -body && body > 0.0;
    let first = if is_inside { body } else { first };
    let last = if is_before && last > -body { -body } else { last };
    let reach = trig::sqrt(positive(reach_squared - squared));
    [if first > -reach { first } else { -reach }, if last < reach { last } else { reach }]
}
