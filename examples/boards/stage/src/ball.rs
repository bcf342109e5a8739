//! The ball.

mod lines;

use luminaire::{Fx16, Vec3, number::Length};

use super::camera::{Window, steps};
use super::measures::{BALL, BALL_RADIUS};
use super::way::{Passage, Way, Wedge};

pub(super) use lines::Lines;

/// The pixels in which the ball can be visible.
pub(super) const fn window<const WIDTH: usize>() -> Window {
    Window::about::<WIDTH>(BALL, [BALL_RADIUS; 3])
}

const MIDDLE: Vec3<i32> = Vec3::new(steps(BALL[0]), steps(BALL[1]), steps(BALL[2]));
/// One over the radius, as a factor from steps of 2^-16 to steps of 2^-30.
const RECIPROCAL: i32 = (16_384.0 / BALL_RADIUS) as i32;

/// The normal at a point of the ball.
#[inline(always)]
pub(super) fn normal(point: Vec3<Length>) -> Vec3<Fx16> {
    point.zip(MIDDLE, |p, middle| {
        let product = (p.to_bits() - middle) * RECIPROCAL;
        Fx16::from_bits(((product + (1 << 15)) >> 16) as i16)
    })
}

/// Where the ball can shadow a point.
pub(super) const WEDGE: Wedge = Wedge::of_ball(BALL, BALL_RADIUS);

/// Whether the ball is between a point outside it and the light.
#[inline(always)]
pub(super) fn is_between(way: &Way) -> bool {
    Passage::of(way.whole, way.to(MIDDLE), steps(BALL_RADIUS) >> 4).is_some()
}
