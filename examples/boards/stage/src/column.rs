//! The column.

use core::ops::Range;

use luminaire::{Fx16, Vec3, number::Length};

use super::camera::{Sight, Window, steps};
use super::measures::{COLUMN, COLUMN_HEIGHT, COLUMN_RADIUS, EYE};
use super::quadratic::Quadratic;
use super::site::{Site, UP};
use super::way::{Passage, Way, Wedge};

/// The pixels in which the column can be visible.
const fn window<const WIDTH: usize>() -> Window {
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

/// A vertical line on the side of the column: what a column of pixels sees of it.
#[derive(Clone, Copy, Default, Debug)]
struct Edge {
    /// The depth; zero if the pixels miss the column.
    depth: i32,
    x: Length,
    z: Length,
    normal: Vec3<Fx16>,
}

/// The side of the column as the columns of pixels in the window see it, in every row.
#[derive(Debug)]
pub(super) struct Side([Edge; Side::MOST]);

impl Side {
    /// Largest number of columns in the window of a picture.
    const MOST: usize = 48;

    pub(super) fn new<const WIDTH: usize>() -> Self {
        const { assert!(window::<WIDTH>().columns().end - window::<WIDTH>().columns().start <= Self::MOST) };
        let mut edges = [Edge::default(); Self::MOST];
        for (edge, column) in edges.iter_mut().zip(const { window::<WIDTH>() }.columns()) {
            let sight = Sight::<WIDTH>::through(column, 0);
            if let Some(depth) = side(sight) {
                let point = sight.point(depth);
                *edge = Edge { depth, x: point.x, z: point.z, normal: normal(point) };
            }
        }
        Self(edges)
    }

    /// Draws the column's part of a row, and returns its columns. The eye is higher than the column, so
    /// every line of sight reaches the top from above.
    #[inline(always)]
    pub(super) fn draw<const WIDTH: usize>(&self, row: i32, sites: &mut [Site; WIDTH]) -> Range<usize> {
        let window = const { window::<WIDTH>() };
        let mut columns = 0..0;
        if !window.has(row) {
            return columns;
        }
        let top = Sight::<WIDTH>::through(0, row).fall_to(COLUMN_HEIGHT);
        for ((column, site), edge) in window.of(row, sites).zip(&self.0) {
            if edge.depth == 0 {
                continue;
            }
            let sight = Sight::<WIDTH>::through(column, row);
            let y = sight.height(edge.depth);
            if y <= steps(COLUMN_HEIGHT) {
                if y < 0 {
                    continue;
                }
                let point = Vec3::new(edge.x, Length::from_bits(y), edge.z);
                *site = Site { point, normal: edge.normal };
            } else if let Some(point) = top.map(|depth| sight.point(depth)).filter(is_over) {
                *site = Site { point, normal: UP };
            } else {
                continue;
            }
            // The column is convex: it is in one stretch of a row.
            columns = if columns.is_empty() { column..column + 1 } else { columns.start..column + 1 };
        }
        columns
    }
}

/// The depth at which a line of sight meets the side, as if it had no ends.
fn side<const WIDTH: usize>(sight: Sight<WIDTH>) -> Option<i32> {
    let along = (sight.right * steps(WAY[0] / 16.0)) >> 8;
    Quadratic { a: sight.right_squared() + (1 << 20), b: along + steps(16.0 * WAY[1]), c: GAP }.depth()
}

/// The offset from the column's axis to a point: right and to the front.
#[inline(always)]
fn from_middle(point: Vec3<Length>) -> [i32; 2] {
    [point.x.to_bits() - steps(COLUMN[0]), point.z.to_bits() - steps(COLUMN[1])]
}

/// Whether a point is within the column's circle, seen from above.
#[inline(always)]
pub(super) fn is_over(point: &Vec3<Length>) -> bool {
    let [right, front] = from_middle(*point).map(|way| way >> 4);
    let radius = steps(COLUMN_RADIUS) >> 4;
    right * right + front * front < radius * radius
}

/// The normal at a point of the column's side.
fn normal(point: Vec3<Length>) -> Vec3<Fx16> {
    let [right, front] =
        from_middle(point).map(|way| Fx16::from_bits(((way * RECIPROCAL + (1 << 15)) >> 16) as i16));
    Vec3::new(right, Fx16::ZERO, front)
}

/// Where the column can shadow a point.
pub(super) const WEDGE: Wedge = Wedge::of_column(COLUMN, COLUMN_RADIUS, COLUMN_HEIGHT);

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
