//! A view ray as the lamp sees it: an arc of directions.

use super::ViewRay;
use crate::{scalar::float::positive, trig, vec3::Vec3};

/// Where a beam has light: the lamp and its axis, the lamp's radius and the light's range, both squared.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub(super) position: Vec3<f32>,
    pub(super) axis: Vec3<f32>,
    pub(super) radius_squared: f32,
    pub(super) reach_squared: f32,
}

/// The part of a view ray between the lamp's body and its range, as an arc of directions from the lamp.
///
/// The arc lies on a great circle. A direction on it is `v`, the tangent of half the angle to the direction of the circle
/// that is nearest to the axis. Places on the ray itself count from the foot, where it comes nearest to the lamp.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    direction: Vec3<f32>,
    /// The way from the lamp to the foot, its length and the reciprocal of that.
    foot: Vec3<f32>,
    height: f32,
    reciprocal: f32,
    /// The cosines of the axis with the foot and with the ray.
    across: f32,
    along: f32,
    /// The cosine and the versine of the angle between axis and circle.
    radius: f32,
    least: f32,
    /// The ends, as places on the ray and as directions.
    first: f32,
    last: f32,
    from: f32,
    to: f32,
    /// The length of the arc from `from` to `to` over that of the foot, not from the difference of the two.
    worth: f32,
}

/// The part of an arc within a cone, in `v`, and what a unit of `v` there is worth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) from: f32,
    pub(super) to: f32,
    pub(super) scale: f32,
}

/// How near a line passes the lamp that counts as going through it, squared, in units of the lamp's radius. What is so
/// near is within the lamp, and from its surface on all directions are those of the ray.
const THROUGH: f32 = 1e-14;

/// A shorter arc takes its worth from the way along the ray, because the difference of its ends has lost bits.
const SHORT: f32 = 1.0 / 16.0;

/// The shortest arc, in units of the cone's. A shorter one is lengthened and worth as much less, so that it does not matter
/// if its ends are rounded to one.
const SHORTEST: f32 = 1.0 / 262_144.0;

impl Arc {
    /// The arc of a view ray.
    #[inline(always)]
    pub(super) fn new(extent: &Extent, view: &ViewRay) -> Self {
        let Extent { position, axis, radius_squared, reach_squared } = *extent;
        let direction = view.direction;
        let eye = view.eye.zip(position, |e, p| e - p);
        // In two steps, because the first leaves a part along the ray that may be longer than a short foot.
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
        // A line through the lamp may have any foot that is across it: one across the axis too.
        let normal = cross(direction, axis);
        let sine = foot.dot(normal) * reciprocal;
        let squared_sine = if is_through { normal.dot(normal) } else { sine * sine };
        let across = if is_through { 0.0 } else { foot.dot(axis) * reciprocal };
        let along = direction.dot(axis);
        let radius = trig::sqrt(positive(1.0 - squared_sine));

        let [first, last] = lit(squared, radius_squared, reach_squared, [start, start + view.length]);
        let tangent = |place: f32, distance: f32| {
            // One plus the cosine; opposite the axis it may be rounded to none.
            let divisor = distance * radius + (across * height + along * place);
            let least = 1e-6 * distance;
            (across * place - along * height) / if divisor > least { divisor } else { least }
        };
        let distance = |place: f32| trig::sqrt(squared + place * place);
        let (near, far) = (distance(first), distance(last));
        let (from, to) = (tangent(first, near), tangent(last, far));
        let way = (last - first) * ((1.0 + from * from) * (1.0 + to * to));
        Self {
            direction,
            foot,
            height,
            reciprocal,
            across,
            along,
            radius,
            least: squared_sine / (1.0 + radius),
            first,
            last,
            from,
            to,
            worth: way / (2.0 * (1.0 + from * to) * (near * far)),
        }
    }

    /// Whether there is any of the ray between lamp and range.
    #[inline(always)]
    pub(super) fn is_any(&self) -> bool {
        self.first < self.last
    }

    /// The direction in which the circle leaves a cone, and zero where it does not meet it.
    #[inline(always)]
    pub(super) fn edge(&self, versine: f32) -> f32 {
        trig::sqrt(positive((versine - self.least) / ((1.0 - versine) + self.radius)))
    }

    /// The part of the arc within an [`edge`](Self::edge), which is at most 1. Empty where `to` is not over `from`.
    #[inline(always)]
    pub(super) fn within(&self, edge: f32) -> Span {
        let length = self.to - self.from;
        // An arc around the far side of the circle comes in at one edge, if at all: it is less than a half circle.
        let is_around = length < 0.0 && self.from * self.to < -0.5;
        let is_short = length < SHORT && !is_around;
        let shortest = SHORTEST * edge;
        let kept = if length > shortest { length } else { shortest };
        let scale = if is_short { self.worth / kept } else { self.reciprocal };
        let from = if is_short { self.to - kept } else { self.from };
        let (from, to) = match is_around {
            true if from < edge => (from, edge),
            true => (-edge, self.to),
            false => (from, self.to),
        };
        let from = if from > -edge { from } else { -edge };
        let to = if to < edge { to } else { edge };
        Span { from, to, scale }
    }

    /// The versine off the axis of a direction on the circle; `share` is `1 / (1 + v^2)`.
    #[inline(always)]
    pub(super) fn versine(&self, v: f32, share: f32) -> f32 {
        self.least + 2.0 * self.radius * (v * v) * share
    }

    /// The place on the ray that lies in a direction, and its distance from the lamp, squared.
    #[inline(always)]
    pub(super) fn place(&self, v: f32) -> (f32, f32) {
        let (cosine, sine) = (1.0 - v * v, 2.0 * v);
        let place = self.height * (sine * self.across + cosine * self.along);
        let divisor = positive(cosine * self.across - sine * self.along);
        // Without a divisor the direction is that of the ray, and the place beyond either end.
        let place = place / if divisor > f32::MIN_POSITIVE { divisor } else { f32::MIN_POSITIVE };
        let place = if place > self.first { place } else { self.first };
        let place = if place < self.last { place } else { self.last };
        (place, self.height * self.height + place * place)
    }

    /// The point of the world at a place on the ray.
    #[inline(always)]
    pub(super) fn point(&self, position: Vec3<f32>, place: f32) -> Vec3<f32> {
        position.zip(self.foot, |p, f| p + f).zip(self.direction, |p, d| p + place * d)
    }
}

/// What is left of a ray between two places: not within the lamp, not behind it, and not beyond the range.
#[inline(always)]
fn lit(squared: f32, radius_squared: f32, reach_squared: f32, [first, last]: [f32; 2]) -> [f32; 2] {
    let body = trig::sqrt(positive(radius_squared - squared));
    let is_inside = -body < first && first < body;
    let is_before = first <= -body && body > 0.0;
    let first = if is_inside { body } else { first };
    let last = if is_before && last > -body { -body } else { last };
    let reach = trig::sqrt(positive(reach_squared - squared));
    [if first > -reach { first } else { -reach }, if last < reach { last } else { reach }]
}

/// The vector product.
#[inline(always)]
pub(super) fn cross(a: Vec3<f32>, b: Vec3<f32>) -> Vec3<f32> {
    Vec3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}
