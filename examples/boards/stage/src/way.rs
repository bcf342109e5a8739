//! The way from a point to the light, and where an object can stand in it.

use core::ops::Range;

use luminaire::{Vec3, number::Length};

use super::camera::steps;
use super::measures::LIGHT;

/// Where an object can shadow a point: between two lines from the light that touch it, seen from
/// above, and between two others, seen from the side. This tells most points of the wall and the
/// floor from those that need the exact test.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wedge {
    /// How far the lines go to the right for each metre into the depth, in steps of 2^-12.
    across: [i32; 2],
    /// How far the lines go up for each metre into the depth, in steps of 2^-12.
    up: [i32; 2],
}

impl Wedge {
    /// The wedge of a ball.
    pub(super) const fn of_ball([x, y, z]: [f32; 3], radius: f32) -> Self {
        let far = LIGHT[2] - z;
        Self { across: tangents(x - LIGHT[0], far, radius), up: tangents(y - LIGHT[1], far, radius) }
    }

    /// The wedge of a column that stands on the floor. The light is higher.
    pub(super) const fn of_column([x, z]: [f32; 2], radius: f32, height: f32) -> Self {
        let far = LIGHT[2] - z;
        let [foot, top] = [-LIGHT[1] / (far - radius), (height - LIGHT[1]) / (far + radius)];
        Self { across: tangents(x - LIGHT[0], far, radius), up: [steps(foot) >> 4, steps(top + 0.01) >> 4] }
    }

    /// The x coordinates between which the points of a row can be in shadow.
    #[inline(always)]
    pub(super) fn at(self, [height, depth]: [Length; 2]) -> Range<Length> {
        let far = (steps(LIGHT[2]) - depth.to_bits()) >> 4;
        let ends =
            |start, slopes: [i32; 2]| slopes.map(|slope| Length::from_bits(start + ((slope * far) >> 8)));
        let [low, high] = ends(steps(LIGHT[1]), self.up);
        let [left, right] = ends(steps(LIGHT[0]), self.across);
        if (low..high).contains(&height) { left..right } else { left..left }
    }
}

/// The slopes of the lines through the origin that touch a circle around the point `[x, far]`.
const fn tangents(x: f32, far: f32, radius: f32) -> [i32; 2] {
    // The rounding of the slopes moves the lines by some millimetres.
    let radius = radius + 0.01;
    let length = root(x * x + far * far - radius * radius);
    let [left, right] = [-radius, radius];
    [tangent(x, far, length, left), tangent(x, far, length, right)]
}

/// The slope of the line through the origin that passes the point `[x, far]` at a distance, and is
/// next to it after `length`.
const fn tangent(x: f32, far: f32, length: f32, distance: f32) -> i32 {
    steps((x * length + far * distance) / (far * length - x * distance)) >> 4
}

/// The square root of a number between 1 and 100, by Newton's method.
const fn root(square: f32) -> f32 {
    let (mut root, mut rounds) = (square, 0);
    while rounds < 10 {
        root = (root + square / root) / 2.0;
        rounds += 1;
    }
    root
}

/// The offset from a point to the light, in steps of 2^-12, so that the sum of three squares fits
/// 32 bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    start: Vec3<i32>,
    /// The offset from the start to the light.
    pub(super) whole: Vec3<i32>,
}

impl Way {
    /// The offset from a point to the light.
    #[inline(always)]
    pub(super) fn to_light(point: Vec3<Length>) -> Self {
        const END: Vec3<i32> = Vec3::new(steps(LIGHT[0]), steps(LIGHT[1]), steps(LIGHT[2]));
        let start = point.map(Length::to_bits);
        Self { start, whole: END.zip(start, |end, start| (end - start) >> 4) }
    }

    /// The point from which the offset starts.
    #[inline(always)]
    pub(super) fn point(&self) -> Vec3<Length> {
        self.start.map(Length::from_bits)
    }

    /// The offset from its start to a position.
    #[inline(always)]
    pub(super) fn to(&self, place: Vec3<i32>) -> Vec3<i32> {
        place.zip(self.start, |place, start| (place - start) >> 4)
    }
}

/// How a line to the light passes through a round object, as inner products in steps of 2^-9, so
/// that their products fit 32 bits. This precision moves the outline of a shadow by some
/// millimetres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage {
    /// The inner product of the whole offset with itself: its squared length.
    pub(super) squared: i32,
    /// The inner product of the whole offset with the offset to the object's centre. The line is
    /// nearest to the centre at the fraction `nearest / squared` of its length.
    pub(super) nearest: i32,
    /// The line enters the object at the fraction `(nearest - sqrt(within)) / squared` of its
    /// length.
    pub(super) within: u32,
}

impl Passage {
    /// The passage of a line that starts outside the object, or `None` if it misses the object.
    /// `middle` is the offset from the line's start to the object's centre.
    #[inline(always)]
    pub(super) fn of(way: Vec3<i32>, middle: Vec3<i32>, radius: i32) -> Option<Self> {
        let nearest = dot(way, middle);
        let gap = dot(middle, middle) - radius * radius;
        if nearest <= 0 || gap <= 0 {
            return None;
        }
        let [squared, nearest, gap] = [dot(way, way), nearest, gap].map(|square| square >> 15);
        let within = u32::try_from(nearest * nearest - squared * gap).ok().filter(|within| *within > 0)?;
        Some(Self { squared, nearest, within })
    }
}

/// The inner product of two offsets, in steps of 2^-24.
#[inline(always)]
fn dot(a: Vec3<i32>, b: Vec3<i32>) -> i32 {
    a.x * b.x + a.y * b.y + a.z * b.z
}
