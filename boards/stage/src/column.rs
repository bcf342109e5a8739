//! The column.

use luminaire::{Fx16, Vec3, number::Length};

use super::camera::{DEPTH_BITS, Sight, Window, steps};
use super::measures::{COLUMN, COLUMN_HEIGHT, COLUMN_RADIUS, EYE};
use super::quadratic::Quadratic;
use super::shadow::{Passage, Way};

/// The pixels in which the column can be visible.
pub(super) const fn window<const WIDTH: usize>() -> Window {
    Window::about::<WIDTH>(
        [COLUMN[0], COLUMN_HEIGHT / 2.0, COLUMN[1]],
        [COLUMN_RADIUS, COLUMN_HEIGHT / 2.0, COLUMN_RADIUS],
    )
}

/// The offset from the eye to the column's axis: right and ahead.
const WAY: [f32; 2] = [COLUMN[0] - EYE[0], EYE[2] - COLUMN[1]];
/// The squared length of `WAY` minus the squared radius, in steps of 2^-20.
const GAP: i32 = steps(16.0 * (WAY[0] * WAY[0] + WAY[1] * WAY[1] - COLUMN_RADIUS * COLUMN_RADIUS));
/// One over the radius, as a factor from steps of 2^-16 to steps of 2^-30.
const RECIPROCAL: i32 = (16_384.0 / COLUMN_RADIUS) as i32;

/// Where a line of sight meets the column.
#[derive(Clone, Copy, Debug)]
pub(super) enum Meeting {
    /// At the side, at this depth.
    Side(i32),
    /// On top, at this depth.
    Top(i32),
}

/// Where a line of sight meets the column. The eye is higher than the column, so every line reaches
/// the top from above.
#[inline(always)]
pub(super) fn meet<const WIDTH: usize>(sight: Sight<WIDTH>) -> Option<Meeting> {
    let [right, _, ahead] = sight.squares();
    let along = (sight.right * steps(WAY[0] / 16.0)) >> 8;
    let across = Quadratic { a: right + ahead, b: along + steps(16.0 * WAY[1]), c: GAP };
    let depth = across.depth()?;
    let height = sight.height(depth);
    if height <= steps(COLUMN_HEIGHT) {
        return (height >= 0).then_some(Meeting::Side(depth));
    }
    let drop = steps(EYE[1] - COLUMN_HEIGHT).cast_unsigned();
    let depth = (drop << DEPTH_BITS).checked_div(u32::try_from(-sight.up).ok()?)?.cast_signed();
    is_over(sight.point(depth)).then_some(Meeting::Top(depth))
}

/// The offset from the column's axis to a point: right and to the front.
#[inline(always)]
fn from_middle(point: Vec3<Length>) -> [i32; 2] {
    [point.x.to_bits() - steps(COLUMN[0]), point.z.to_bits() - steps(COLUMN[1])]
}

/// Whether a point is within the column's circle, seen from above.
#[inline(always)]
fn is_over(point: Vec3<Length>) -> bool {
    let [right, front] = from_middle(point).map(|way| way >> 4);
    let radius = steps(COLUMN_RADIUS) >> 4;
    right * right + front * front < radius * radius
}

/// The normal at a point of the column's side.
#[inline(always)]
pub(super) fn normal(point: Vec3<Length>) -> Vec3<Fx16> {
    let [right, front] =
        from_middle(point).map(|way| Fx16::from_bits(((way * RECIPROCAL + (1 << 15)) >> 16) as i16));
    Vec3::new(right, Fx16::ZERO, front)
}

/// Whether the column is between a point outside it and the light, which hangs higher.
#[inline(always)]
pub(super) fn is_between(way: &Way) -> bool {
    let top = way.to(Vec3::new(steps(COLUMN[0]), steps(COLUMN_HEIGHT), steps(COLUMN[1])));
    let flat = |way: Vec3<i32>| Vec3 { y: 0, ..way };
    // The line to the light must be below the top where it enters the column's circle.
    Passage::of(flat(way.whole), flat(top), steps(COLUMN_RADIUS) >> 4).is_some_and(|passage| {
        let entry = passage.nearest - passage.within.isqrt().cast_signed();
        entry * way.whole.y < passage.squared * top.y
    })
}
