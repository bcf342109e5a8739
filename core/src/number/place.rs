//! Where a point stands on the square that a spotlight projects.

use super::Scalar;

/// Where a point stands on the square of a [`Projection`](crate::projector::Projection), and how deep in the light.
///
/// Columns and rows are counted as those of a picture on the wall that the light shines at, seen from the light: columns
/// from its left edge, rows from its top. They are rounded down. One that is farther than a side from the square is that
/// far, and what is behind the light, on it or not a number is off the square.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ProjectedPoint<S: Scalar> {
    /// The way from the left edge in 65,536ths of a side: 0 to 65,535 on the square, and in all -65,536 to 131,071.
    pub column: i32,
    /// The way from the top edge, likewise.
    pub row: i32,
    /// The part of the way from the light that goes along its axis: from zero up, and zero behind the light.
    pub depth: S::Length,
}

/// How many steps of a place a side has.
pub(crate) const STEPS: i32 = 1 << 16;

impl<S: Scalar> ProjectedPoint<S> {
    /// The place of what has none.
    #[cfg(feature = "fixed")]
    #[inline]
    pub(super) fn outside() -> Self {
        Self { column: -STEPS, row: -STEPS, depth: S::Length::default() }
    }

    /// Whether it is on the square.
    #[inline]
    pub const fn is_inside(&self) -> bool {
        ((self.column | self.row) as u32) < STEPS as u32
    }
}
