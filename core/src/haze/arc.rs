//! A view ray as the light sees it: an arc of directions.

use super::ViewRay;
use crate::{number::float::positive, trig, vec3::Vec3};

/// Where a beam has light: the light's place and axis, its radius and its range, both squared.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub(super) position: Vec3<f32>,
    pub(super) axis: Vec3<f32>,
    pub(super) radius_squared: f32,
    pub(super) reach_squared: f32,
}

/// The part of a view ray between the light's body and its range, as an arc of directions from the light.
///
/// The arc lies on a great circle. A direction on it is `v`, the tangent of half the angle to the direction
/// of the circle that is nearest to the axis. Places on the ray itself count from the foot, where it comes
/// nearest to the light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    direction: Vec3<f32>,
    /// The way from the light to the foot, its length and the reciprocal of that.
    foot: Vec3<f32>,
    height: f32,
    reciprocal: f32,
    /// The cosines of the axis with the foot and with the ray.
    across: f32,
    along: f32,
    /// The cosine and the versine of the angle between axis and circle.
    radius: f32,
    least: f32,
    /// The ends, as places on the ray.
    first: f32,
    last: f32,
}

/// The part of an arc within a cone, in `v`, and what a unit of `v` there is worth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) from: f32,
    pub(super) to: f32,
    pub(super) scale: f32,
}

/// How near a line passes the light that counts as going through it, squared, in units of the light's radius.
/// What is so near is within the light's body, and from its surface on all directions are those of the ray.
const THROUGH: f32 = 1e-14;

/// A shorter arc takes its worth from the way along the ray, because the difference of its ends has lost
/// bits.
const SHORT: f32 = 1.0 / 16.0;

/// The shortest arc, in units of the cone's. A shorter one is lengthened and worth as much less, so that it
/// does not matter if its ends are rounded to one.
const SHORTEST: f32 = 1.0 / 262_144.0;

/// What stands for the tangent of a right angle.
const OPPOSITE: f32 = 1e6;

impl Arc {
    /// The arc of a view ray.
    #[inline(always)] // Turntable in haze on x86-64: 2.2 times the instructions without.
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
        // A line through the light's place may have any foot that is across it: one across the axis too.
        let normal = cross(direction, axis);
        let sine = foot.dot(normal) * reciprocal;
        let squared_sine = if is_through { normal.dot(normal) } else { sine * sine };
        let across = if is_through { 0.0 } else { foot.dot(axis) * reciprocal };
        let along = direction.dot(axis);
        // From the sine it would have no bits where the circle is nearly across the axis.
        let radius = trig::sqrt(across * across + along * along);

        let [first, last] = lit(squared, radius_squared, reach_squared, [start, start + view.length]);
        let least = squared_sine / (1.0 + radius);
        Self { direction, foot, height, reciprocal, across, along, radius, least, first, last }
    }

    /// Whether there is any of the ray between light and range.
    #[inline]
    pub(super) fn is_any(&self) -> bool {
        self.first < self.last
    }

    /// The direction in which the circle leaves a cone, and zero where it does not meet it.
    #[inline]
    pub(super) fn edge(&self, versine: f32) -> f32 {
        trig::sqrt(positive((versine - self.least) / ((1.0 - versine) + self.radius)))
    }

    /// The part of the arc within an [`edge`](Self::edge), which is at most 1. Empty where `to` is not over
    /// `from`.
    #[inline(always)] // Turntable in haze on x86-64: +1.9 % without.
    pub(super) fn span(&self, edge: f32) -> Span {
        let (near, far) = (self.distance(self.first), self.distance(self.last));
        let (from, to) = (self.toward(self.first, near), self.toward(self.last, far));
        let length = to - from;
        // `v` rises along a ray, but where the arc passes the far side of its circle. The sign of
        // `v` is that of a sine which is monotone in the place, roundings included; the difference
        // of the ends is rounding alone near the far side. Such an arc comes in at one edge, if at
        // all: it is less than a half circle.
        let is_around = from > 0.0 && to < 0.0;
        let is_short = length < SHORT && !is_around;
        // The length again, over that of the foot, and not from the difference of the ends.
        let way = (self.last - self.first) * ((1.0 + from * from) * (1.0 + to * to));
        let worth = way / (2.0 * (1.0 + from * to) * (near * far));
        let shortest = SHORTEST * edge;
        let kept = if length > shortest { length } else { shortest };
        let begin = if is_short { to - kept } else { from };
        // Over the length that is left when its beginning has been rounded.
        let scale = if is_short { worth / (to - begin) } else { self.reciprocal };
        let comes_in_last = is_around && from >= edge;
        let begin = if comes_in_last || begin < -edge { -edge } else { begin };
        let end = if (is_around && from < edge) || to > edge { edge } else { to };
        Span { from: begin, to: end, scale }
    }

    /// The versine off the axis in a direction on the circle; `share` is `1 / (1 + v^2)`.
    #[inline]
    pub(super) fn versine(&self, v: f32, share: f32) -> f32 {
        self.least + 2.0 * self.radius * (v * v) * share
    }

    /// Where on the ray a cone of this [`edge`](Self::edge) begins and ends. One that is not met is at the
    /// last place, or where the ray is nearest to the axis.
    #[inline]
    pub(super) fn between(&self, edge: f32) -> [f32; 2] {
        let (cosine, sine) = (1.0 - edge * edge, 2.0 * edge);
        // The cosines with the foot of either edge, up to a factor. One that is not positive is beyond an
        // end of the line.
        let lower = cosine * self.across + sine * self.along;
        let upper = cosine * self.across - sine * self.along;
        let from = self.inside(self.height * (cosine * self.along - sine * self.across) / lower);
        let to = self.inside(self.height * (cosine * self.along + sine * self.across) / upper);
        let is_missed = (lower < 0.0 && upper < 0.0) || (edge <= 0.0 && self.across <= 0.0);
        let from = if lower > 0.0 { from } else { self.first };
        [if is_missed { self.last } else { from }, if upper > 0.0 && !is_missed { to } else { self.last }]
    }

    /// A place on the line, brought to the ray.
    #[inline]
    fn inside(&self, place: f32) -> f32 {
        let place = if place > self.first { place } else { self.first };
        if place < self.last { place } else { self.last }
    }

    /// The distance of a place on the ray from the light.
    #[inline]
    pub(super) fn distance(&self, place: f32) -> f32 {
        trig::sqrt(self.height * self.height + place * place)
    }

    /// What makes a sine and one plus a cosine of a place on the ray, seen from the direction nearest to
    /// the axis: both times the distance and the cosine of the circle.
    #[inline]
    fn turn(&self, place: f32, distance: f32) -> (f32, f32) {
        let sine = self.across * place - self.along * self.height;
        (sine, distance * self.radius + (self.across * self.height + self.along * place))
    }

    /// The direction of a place on the ray at this distance.
    #[inline]
    fn toward(&self, place: f32, distance: f32) -> f32 {
        let (sine, one_plus_cosine) = self.turn(place, distance);
        // Opposite the axis that is none, but for the roundings.
        let far = if sine < 0.0 { -OPPOSITE } else { OPPOSITE };
        if one_plus_cosine * OPPOSITE > distance { sine / one_plus_cosine } else { far }
    }

    /// The versine off the axis of a place on the ray at this distance; any that is over 1 where it is over
    /// 1.
    #[inline]
    pub(super) fn versine_at(&self, place: f32, distance: f32) -> f32 {
        let (sine, one_plus_cosine) = self.turn(place, distance);
        let is_ahead = one_plus_cosine > distance * self.radius;
        self.least + if is_ahead { sine * sine / (distance * one_plus_cosine) } else { 1.0 }
    }

    /// The place on the ray that lies in a direction.
    #[inline]
    pub(super) fn place(&self, v: f32) -> f32 {
        let (cosine, sine) = (1.0 - v * v, 2.0 * v);
        let across = positive(cosine * self.across - sine * self.along);
        let along = self.height * (sine * self.across + cosine * self.along);
        self.inside(along / if across > f32::MIN_POSITIVE { across } else { f32::MIN_POSITIVE })
    }

    /// The point of the world at a place on the ray.
    #[inline]
    pub(super) fn point(&self, position: Vec3<f32>, place: f32) -> Vec3<f32> {
        position.zip(self.foot, |p, f| p + f).zip(self.direction, |p, d| p + place * d)
    }
}

/// What is left of a ray between two places: not within the light's body, not behind it, and not beyond the range.
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

/// The vector product.
#[inline]
pub(super) fn cross(a: Vec3<f32>, b: Vec3<f32>) -> Vec3<f32> {
    Vec3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}
