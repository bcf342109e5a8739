//! Finds the visible point of each pixel: the nearest of wall, floor, ball and column.

use core::ops::Range;

use super::backdrop::{Backdrop, Seen};
use super::ball::{self, Lines};
use super::camera::Sight;
use super::column::Side;
use super::site::Site;

/// Finds what the pixels of a row see. Of the sites only those of objects are set.
#[inline(never)]
pub(crate) fn look<const WIDTH: usize>(seen: &mut Seen, side: &Side, row: i32, sites: &mut [Site; WIDTH]) {
    seen.backdrop = Backdrop::of::<WIDTH>(row);
    // Nothing is in front of the ball, so it is drawn last.
    seen.objects = [side.draw(row, sites), draw_ball(row, sites)];
}

/// Draws the ball's part of a row, and returns its columns.
fn draw_ball<const WIDTH: usize>(row: i32, sites: &mut [Site; WIDTH]) -> Range<usize> {
    let window = const { ball::window::<WIDTH>() };
    let mut columns = 0..0;
    if !window.has(row) {
        return columns;
    }
    let mut lines = Lines::new::<WIDTH>(window.columns().start, row);
    for (column, site) in window.of(row, sites) {
        let Some(depth) = lines.next_depth() else {
            // The ball is convex: it is in one stretch of a row.
            if columns.is_empty() { continue } else { break }
        };
        let point = Sight::<WIDTH>::through(column, row).point(depth);
        *site = Site { point, normal: ball::normal(point) };
        columns = if columns.is_empty() { column..column + 1 } else { columns.start..column + 1 };
    }
    columns
}
