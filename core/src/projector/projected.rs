//! Position of a point on the square that a spotlight projects.

use crate::number::{STEPS, Scalar};

/// Position of a point on the square of a [`Projection`](crate::projector::Projection), and its
/// depth.
///
/// Imagine the square as a picture on a wall that the light shines at, seen from the light. Columns
/// count from the left edge of the picture, rows from its top edge. Column and row are rounded
/// down, and saturate one side length outside the square. Points at or behind the light, and NaN,
/// map outside the square.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ProjectedPoint<S: Scalar> {
    /// Distance from the left edge in units of 1/65,536 of a side.
    ///
    /// In `[0, 65535]` on the square, and always in `[-65536, 131071]`.
    pub column: i32,
    /// Distance from the top edge, in the unit and range of `column`.
    pub row: i32,
    /// Distance from the light along its axis: at least 0, and 0 behind the light.
    pub depth: S::Length,
}

impl<S: Scalar> ProjectedPoint<S> {
    /// Returns whether the position is on the square.
    #[inline]
    pub const fn is_inside(&self) -> bool {
        ((self.column | self.row) as u32) < STEPS as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_ends_at_its_last_step() {
        let is_inside = |column, row| ProjectedPoint::<f32> { column, row, depth: 1.0 }.is_inside();
        assert!(is_inside(0, 0) && is_inside(65_535, 0) && is_inside(0, 65_535));
        assert!(![(65_536, 0), (0, 65_536), (-1, 0), (0, -1)].into_iter().any(|(c, r)| is_inside(c, r)));
    }
}
