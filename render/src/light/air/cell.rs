//! The size of a tile, and its cells: squares at whose nodes rays are evaluated.

use crate::{buffer::LANES, stripes::Stripes};

/// The size of a tile in pixels.
pub(super) const COLUMNS: usize = LANES;
pub(super) const ROWS: usize = Stripes::ROWS;

/// A square of pixels with three rows of three nodes, `step` pixels apart. The last row and the
/// last column of nodes are those of the next cells.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Cell {
    pub(super) x: usize,
    pub(super) y: usize,
    pub(super) step: usize,
}

impl Cell {
    pub(super) fn side(&self) -> usize {
        2 * self.step
    }

    /// The pixels of the nodes, row by row.
    pub(super) fn nodes(self) -> impl Iterator<Item = (usize, usize)> + Clone {
        (0..9).map(move |i| (self.x + i % 3 * self.step, self.y + i / 3 * self.step))
    }

    pub(super) fn middle(self) -> (usize, usize) {
        (self.x + self.step, self.y + self.step)
    }

    pub(super) fn quarters(&self) -> [Self; 4] {
        core::array::from_fn(|i| Self {
            x: self.x + i % 2 * self.step,
            y: self.y + i / 2 * self.step,
            step: self.step / 2,
        })
    }
}
