//! Where view rays end: bounds of the surfaces in front of which a tile's air is.

use super::cell::{COLUMNS, ROWS};

/// A nearness that is linear on the screen, like that of a flat surface.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub(super) struct Plane {
    pub(super) at_first: f32,
    pub(super) per_column: f32,
    pub(super) per_row: f32,
}

/// Bounds of the nearness at the pixels of a cell: two parallel planes.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Ends {
    pub(super) far: Plane,
    pub(super) near: Plane,
    /// Whether the planes are the same within the rounding of the nearness.
    pub(super) is_flat: bool,
}

/// Relative difference of two planes that counts as none: about fifty roundings of f32.
const FLAT: f32 = 3e-6;

/// Relative difference of two planes from which on the cell counts as containing an outline, so
/// that constant bounds are tighter.
const OUTLINE: f32 = 0.02;

/// The nearness of a tile's pixels.
pub(super) type Nearness = [[f32; COLUMNS]; ROWS];

impl Plane {
    /// Returns the nearness at a pixel, at least 0.
    #[inline(always)]
    pub(super) fn at(&self, (x, y): (usize, usize)) -> f32 {
        let nearness = self.at_first + (self.per_column * x as f32 + self.per_row * y as f32);
        if nearness > 0.0 { nearness } else { 0.0 }
    }

    fn moved(self, by: f32) -> Self {
        Self { at_first: self.at_first + by, ..self }
    }

    fn constant(at_first: f32) -> Self {
        Self { at_first, per_column: 0.0, per_row: 0.0 }
    }
}

impl Ends {
    /// Returns the bounds of a flat surface.
    pub(super) fn flat(plane: Plane) -> Self {
        Self { far: plane, near: plane, is_flat: true }
    }

    /// Returns the surface if it is flat.
    pub(super) fn plane(&self) -> Option<Plane> {
        self.is_flat.then_some(self.far)
    }

    /// Returns the bounds at the pixels of a rectangle.
    #[inline(always)]
    pub(super) fn of(
        nearness: &Nearness,
        columns: core::ops::Range<usize>,
        rows: core::ops::Range<usize>,
    ) -> Self {
        let (Some(right), Some(bottom)) = (columns.end.checked_sub(1), rows.end.checked_sub(1)) else {
            return Self { is_flat: true, ..Self::default() };
        };
        if columns.is_empty() || rows.is_empty() {
            return Self { is_flat: true, ..Self::default() };
        }
        let (left, top) = (columns.start, rows.start);
        let corner = nearness[top][left];
        let slope = |other: f32, steps: usize| if steps > 0 { (other - corner) / steps as f32 } else { 0.0 };
        let per_column = slope(nearness[top][right], right - left);
        let per_row = slope(nearness[bottom][left], bottom - top);
        let at_first = corner - (per_column * left as f32 + per_row * top as f32);
        let plane = Plane { at_first, per_column, per_row };
        let (mut below, mut above) = (0.0_f32, 0.0_f32);
        let (mut least, mut most) = (corner, corner);
        for (y, row) in nearness.iter().enumerate().take(rows.end).skip(top) {
            let start = at_first + per_row * y as f32;
            for (x, &nearness) in row.iter().enumerate().take(columns.end).skip(left) {
                let off = nearness - (start + per_column * x as f32);
                below = if off < below { off } else { below };
                above = if off > above { off } else { above };
                least = if nearness < least { nearness } else { least };
                most = if nearness > most { nearness } else { most };
            }
        }
        if above - below > OUTLINE * most {
            return Self { far: Plane::constant(least), near: Plane::constant(most), is_flat: false };
        }
        Self { far: plane.moved(below), near: plane.moved(above), is_flat: above - below <= FLAT * least }
    }
}
