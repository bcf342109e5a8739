//! The view rays through a tile.

use super::hazy::BATCH;
use crate::{
    buffer::LANES,
    raster::{Fragments, view::View},
    space::vector,
    stripes::Stripes,
};
use core::ops::Range;
use glam::{DVec3, Vec3};
use luminaire::haze::{RayBundle, ViewRays};

/// The size of a tile in pixels.
pub(super) const COLUMNS: usize = LANES;
pub(super) const ROWS: usize = Stripes::ROWS;

/// The rays from the eye through a tile's pixels.
///
/// A pixel has the coordinates of its centre, in pixels from the centre of the tile's first pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fan {
    eye: Vec3,
    /// Vectors at depth 1: from the eye to the first pixel, to the next column and to the next row.
    first: DVec3,
    column: Vec3,
    row: Vec3,
}

/// The two planes through the eye that touch a beam, in a tile.
pub(super) struct Sides {
    /// The distance of the first pixel at depth 1 from each plane, and its change per column and per
    /// row.
    sides: [[f32; 3]; 2],
    margin: f32,
}

/// Distance of a direction from a side of the beam that counts as beside the beam; see
/// [`sides`](luminaire::haze::BeamScattering::sides).
const MARGIN: f32 = 2e-5;

impl Fan {
    pub(super) fn new(view: &View, row: usize, column: usize) -> Self {
        let (first, across, down) = view.rays(row, column * LANES);
        Self { eye: view.eye(), first, column: across, row: down }
    }

    /// Returns the vectors at depth 1: from the eye to the first pixel, to the next column and to
    /// the next row.
    pub(super) fn vectors(&self) -> [DVec3; 3] {
        [self.first, self.column.as_dvec3(), self.row.as_dvec3()]
    }

    /// Returns the vector to a pixel at depth 1.
    #[inline(always)]
    fn at(&self, x: f32, y: f32) -> Vec3 {
        self.first.as_vec3() + self.column * x + self.row * y
    }

    /// Returns the bundle of the rays through the tile's first pixels, up to this nearness.
    fn bundle(&self, columns: usize, rows: usize, nearness: f32) -> RayBundle {
        let [right, bottom] = [columns, rows].map(|count| count.saturating_sub(1) as f32);
        let corners = [(0.0, 0.0), (right, 0.0), (0.0, bottom), (right, bottom)];
        let ways = corners.map(|(x, y)| self.at(x, y));
        let directions = ways.map(vector::direction);
        let middle = vector::direction(directions.into_iter().sum());
        // The longest ray to depth 1 goes through a corner of the rectangle.
        let longest = ways.into_iter().map(vector::length).fold(0.0, f32::max);
        let directions = directions.map(Into::into);
        RayBundle::around(self.eye.into(), middle.into(), &directions, longest / nearness)
    }

    /// Returns the planes with these normals.
    pub(super) fn sides(&self, normals: &[Vec3; 2]) -> Sides {
        let ways = [self.first.as_vec3(), self.column, self.row];
        let sides = normals.map(|normal| ways.map(|way| way.dot(normal)));
        let corners = [(0, 0), (COLUMNS, 0), (0, ROWS), (COLUMNS, ROWS)];
        let lengths = corners.map(|(x, y)| vector::length(self.at(x as f32, y as f32)));
        Sides { sides, margin: MARGIN * lengths.into_iter().fold(0.0, f32::max) }
    }

    /// Returns the rays through the pixels from `(x, y)` to the right, up to surfaces of this nearness.
    /// A nearness of 0 is a ray without an end.
    #[inline(always)]
    pub(super) fn rays(&self, (x, y): (usize, usize), nearness: &[f32; BATCH]) -> ViewRays<BATCH> {
        let none = [0.0; BATCH];
        let direction = luminaire::Vec3::new(none, none, none);
        let mut rays = ViewRays { eye: self.eye.into(), direction, length: none };
        let start = self.at(0.0, y as f32);
        for (lane, nearness) in nearness.iter().enumerate() {
            let way = start + self.column * (x + lane) as f32;
            let unit = vector::length(way);
            rays.direction.x[lane] = way.x / unit;
            rays.direction.y[lane] = way.y / unit;
            rays.direction.z[lane] = way.z / unit;
            // The ray to depth 1 has the length `unit`.
            rays.length[lane] = unit / nearness;
        }
        rays
    }
}

impl Sides {
    /// No sides.
    pub(super) const NONE: Self = Self { sides: [[0.0; 3]; 2], margin: 0.0 };

    /// Returns the columns of a row between the sides, up to a number.
    #[inline(always)]
    pub(super) fn columns(&self, y: usize, columns: usize) -> Range<usize> {
        let (mut from, mut to) = (0.0_f32, columns as f32);
        for [first, column, row] in self.sides {
            let start = first + row * y as f32 + self.margin;
            // Where the distance is that of the margin.
            let place = -start / column;
            if column > 0.0 {
                from = if place > from { place } else { from };
            } else if column < 0.0 {
                to = if place + 1.0 < to { place + 1.0 } else { to };
            } else if start < 0.0 {
                to = 0.0;
            }
        }
        // Both are at least 0, and a number of columns is a whole number.
        from as usize..to as usize
    }
}

/// Returns the bundle of all rays through a tile. The length of the bundle is the distance to the
/// farthest surface in the tile.
pub(crate) fn bundle(view: &View, fragments: &Fragments, rows: Range<usize>, column: usize) -> RayBundle {
    let fan = Fan::new(view, rows.start, column);
    let nearness = rows.clone().flat_map(|row| fragments.block(row, column));
    let least = nearness.copied().fold(f32::INFINITY, f32::min);
    fan.bundle(LANES, rows.len(), least)
}
