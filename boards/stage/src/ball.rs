//! The ball.

use luminaire::{Fx16, Vec3, number::Length};

use super::camera::{Sight, Window, steps};
use super::measures::{BALL, BALL_RADIUS, EYE};
use super::quadratic::Quadratic;
use super::shadow::{Passage, Way, Wedge};

/// The pixels in which the ball can be visible.
pub(super) const fn window<const WIDTH: usize>() -> Window {
    Window::about::<WIDTH>(BALL, [BALL_RADIUS; 3])
}

const MIDDLE: Vec3<i32> = Vec3::new(steps(BALL[0]), steps(BALL[1]), steps(BALL[2]));
/// The offset from the eye to the ball's centre: right, up and ahead.
const WAY: [f32; 3] = [BALL[0] - EYE[0], BALL[1] - EYE[1], EYE[2] - BALL[2]];
/// The squared length of `WAY` minus the squared radius, in steps of 2^-20.
const GAP: i32 =
    steps(16.0 * (WAY[0] * WAY[0] + WAY[1] * WAY[1] + WAY[2] * WAY[2] - BALL_RADIUS * BALL_RADIUS));
/// One over the radius, as a factor from steps of 2^-16 to steps of 2^-30.
const RECIPROCAL: i32 = (16_384.0 / BALL_RADIUS) as i32;

/// The depth at which a line of sight meets the ball.
#[inline(always)]
pub(super) fn depth<const WIDTH: usize>(sight: Sight<WIDTH>) -> Option<i32> {
    let [right, up, ahead] = sight.squares();
    let along = (sight.right * steps(WAY[0] / 16.0) + sight.up * steps(WAY[1] / 16.0)) >> 8;
    Quadratic { a: right + up + ahead, b: along + steps(16.0 * WAY[2]), c: GAP }.depth()
}

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
