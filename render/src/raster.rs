//! Rasterisation of triangles: exact coverage, and the nearest fragment of each pixel.

mod adjacency;
pub(crate) mod clip;
pub(crate) mod silhouette;
pub(crate) mod view;

use crate::{
    buffer::{LANES, filled},
    raster::view::{Corner, SUBPIXEL_BITS},
    stripes::Stripes,
};
use alloc::{collections::TryReserveError, vec::Vec};

/// One pixel in units of a screen coordinate.
const PIXEL: i64 = 1 << SUBPIXEL_BITS;

/// The size of a picture in pixels, and its rows that are drawn. Rows are padded to the length
/// `stride`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) stride: usize,
    pub(crate) stripes: Stripes,
}

/// Neighbouring pixels of a row that a triangle covers.
pub(crate) struct Span<'a> {
    /// Indices of the pixels, row by row from the top of the drawn rows.
    pub(crate) pixels: core::ops::Range<usize>,
    corners: [&'a Corner; 3],
    /// Barycentric weights of the second and the third corner. Each pair is the weight at the first
    /// pixel, and the change of the weight from one pixel to the next.
    to_b: (f32, f32),
    to_c: (f32, f32),
}

impl Grid {
    /// Returns whether a column and row are in the picture.
    fn has(&self, (x, y): (i64, i64)) -> bool {
        (0..self.width as i64).contains(&x) && (0..self.height as i64).contains(&y)
    }

    /// Calls `fill` with each span that a triangle covers, row by row. The corners must be
    /// counter-clockwise; back faces cover nothing.
    #[inline(always)]
    pub(crate) fn cover(&self, corners: &[Corner; 3], mut fill: impl FnMut(Span<'_>)) {
        // Swaps two corners: the y axis of the screen points down, so the winding is reversed.
        let [a, c, b] = corners;
        let touched = centers([a.y, b.y, c.y], self.height);
        // Most triangles are small, and touch no drawn row if the rows are dealt out.
        let mut rows = self.stripes.next(touched.clone());
        if rows.is_empty() {
            return;
        }
        let columns = centers([a.x, b.x, c.x], self.width);
        let area = doubled_area(a, b, c);
        if columns.is_empty() || area <= 0 {
            return;
        }
        let columns = columns.start as i64..columns.end as i64;
        let share = 1.0 / area as f32;
        while let Some(number) = self.stripes.number(rows.start).filter(|_| !rows.is_empty()) {
            let edge = |from, to| Edge::new(from, to).walk(rows.start as i64);
            let mut edges = [edge(b, c), edge(c, a), edge(a, b)];
            for row in number..number + rows.len() {
                let (mut start, mut end) = (columns.start, columns.end);
                for edge in &edges {
                    edge.narrow(&mut start, &mut end);
                }
                if start < end {
                    let weight = |edge: &Walk| {
                        ((edge.at + start * edge.column) as f32 * share, edge.column as f32 * share)
                    };
                    let first = row * self.stride;
                    fill(Span {
                        pixels: first + start as usize..first + end as usize,
                        corners: [a, b, c],
                        to_b: weight(&edges[1]),
                        to_c: weight(&edges[2]),
                    });
                }
                edges.iter_mut().for_each(Walk::step);
            }
            rows = self.stripes.next(rows.end..touched.end);
        }
    }
}

impl Span<'_> {
    /// Interpolates a value of the corners along the pixels.
    #[inline(always)]
    pub(crate) fn line(&self, of: impl Fn(&Corner) -> f32) -> Line {
        let [a, b, c] = self.corners.map(of);
        Line {
            start: a + self.to_b.0 * (b - a) + self.to_c.0 * (c - a),
            step: self.to_b.1 * (b - a) + self.to_c.1 * (c - a),
        }
    }
}

/// The nearest fragment of each pixel. Rows are padded to whole blocks of [`LANES`] pixels.
#[derive(Clone, Debug)]
pub(crate) struct Fragments {
    grid: Grid,
    /// The reciprocal of the depth; 0 where nothing was drawn.
    pub(crate) nearness: Vec<f32>,
    /// Normals, not normalised.
    pub(crate) normal: [Vec<f32>; 3],
    /// The number of the material; 0 where nothing was drawn.
    pub(crate) material: Vec<u32>,
}

impl Fragments {
    pub(crate) fn new(width: usize, height: usize, stripes: Stripes) -> Result<Self, TryReserveError> {
        let stride = width.next_multiple_of(LANES);
        let count = stride * stripes.height(height);
        let plane = || filled(count, 0.0_f32);
        let normal = [plane()?, plane()?, plane()?];
        let grid = Grid { width, height, stride, stripes };
        Ok(Self { grid, nearness: plane()?, normal, material: filled(count, 0)? })
    }

    /// The nearness, the reciprocal of the depth, of each pixel of a block.
    pub(crate) fn block(&self, row: usize, column: usize) -> &[f32] {
        &self.nearness[row * self.grid.stride + column * LANES..][..LANES]
    }

    /// Returns the nearness and the material of a pixel; `None` outside the drawn rows.
    fn at(&self, (x, y): (i64, i64)) -> Option<(f32, u32)> {
        let row = self.grid.stripes.number(y as usize).filter(|_| self.grid.has((x, y)))?;
        let pixel = row * self.grid.stride + x as usize;
        Some((self.nearness[pixel], self.material[pixel]))
    }

    /// Removes all fragments.
    pub(crate) fn clear(&mut self) {
        self.nearness.fill(0.0);
        self.material.fill(0);
    }

    /// Draws the front face of a triangle at each pixel where the triangle is nearer than the
    /// previous fragment.
    pub(crate) fn draw(&mut self, corners: [Corner; 3], material: u32) {
        let grid = self.grid;
        grid.cover(&corners, |span| {
            let nearness = span.line(|corner| corner.nearness);
            let [x, y, z] = [0, 1, 2].map(|i| span.line(|corner| corner.normal[i]));
            let [nx, ny, nz] = self.normal.each_mut().map(|plane| &mut plane[span.pixels.clone()]);
            let old = &mut self.nearness[span.pixels.clone()];
            fill(old, nx, ny, nz, &mut self.material[span.pixels], [nearness, x, y, z], material);
        });
    }
}

/// Writes the fragments of a span at each pixel where the new fragment is nearer than the previous
/// one. `lines` are the nearness and the normal.
///
/// The planes are arguments of a function that is not inlined, so that compilers know that they do
/// not overlap. Each pixel is written as a whole, drawn or kept: with a condition for each plane,
/// compilers write only the drawn pixels, one after the other.
#[inline(never)]
fn fill(
    old: &mut [f32],
    nx: &mut [f32],
    ny: &mut [f32],
    nz: &mut [f32],
    materials: &mut [u32],
    lines: [Line; 4],
    material: u32,
) {
    let planes = old.iter_mut().zip(nx).zip(ny).zip(nz).zip(materials);
    for (i, ((((old, nx), ny), nz), old_material)) in planes.enumerate() {
        let [new, x, y, z] = lines.map(|line| line.at(i));
        let (drawn, kept) = ((new, x, y, z, material), (*old, *nx, *ny, *nz, *old_material));
        (*old, *nx, *ny, *nz, *old_material) = if new > *old { drawn } else { kept };
    }
}

/// A value that is linear along a span.
#[derive(Clone, Copy)]
pub(crate) struct Line {
    start: f32,
    step: f32,
}

impl Line {
    #[inline(always)]
    pub(crate) fn at(self, i: usize) -> f32 {
        // The cast to `i32` comes first, because vector instructions convert only signed 32-bit
        // integers.
        self.start + self.step * (i as i32) as f32
    }
}

/// Returns the rows or columns whose centres lie within the range of three screen coordinates.
/// There are `count` rows or columns.
fn centers(coordinates: [i32; 3], count: usize) -> core::ops::Range<usize> {
    let [a, b, c] = coordinates;
    first_center(a.min(b).min(c))..first_center(a.max(b).max(c) + 1).min(count)
}

/// Returns the first row or column whose centre is at or after a coordinate, which is not negative.
fn first_center(coordinate: i32) -> usize {
    ((coordinate + PIXEL as i32 / 2 - 1) >> SUBPIXEL_BITS) as usize
}

/// Returns twice the signed area of a triangle on a screen with y down: positive if its corners are
/// clockwise.
fn doubled_area(a: &Corner, b: &Corner, c: &Corner) -> i64 {
    let (x, y) = (i64::from(a.x), i64::from(a.y));
    (i64::from(b.x) - x) * (i64::from(c.y) - y) - (i64::from(b.y) - y) * (i64::from(c.x) - x)
}

/// Returns the corners of a triangle in front-facing order.
pub(crate) fn faced([a, b, c]: [Corner; 3]) -> [Corner; 3] {
    if doubled_area(&a, &b, &c) > 0 { [a, c, b] } else { [a, b, c] }
}

/// An edge of a triangle, in exact integers. On a screen with y down, the triangle lies on the
/// right of the edge.
struct Edge {
    x: i64,
    y: i64,
    dx: i64,
    dy: i64,
}

/// An edge that is evaluated row by row from the top, as in Bresenham's algorithm.
///
/// The edge takes two divisions at the start and no division per row.
struct Walk {
    /// `at` is twice a signed area, positive inside: that of the triangle of the edge and the
    /// centre of the row's first pixel. `column` and `row` are the changes of `at` to the next
    /// column and to the next row.
    at: i64,
    column: i64,
    row: i64,
    /// 0 for a top or left edge, 1 for any other edge. The points on a top or left edge belong to
    /// this triangle, the points on any other edge to the neighbouring triangle.
    excluded: i64,
    /// `whole` is the absolute change of `at` per column. `columns` and `rest` are the quotient and
    /// the remainder of `(at - excluded) / whole`; the quotient gives the column where the edge
    /// crosses the row.
    whole: i64,
    columns: i64,
    rest: i64,
    /// Changes of the quotient `columns` and of the remainder `rest` to the next row.
    more_columns: i64,
    more_rest: i64,
}

impl Edge {
    #[inline(always)]
    fn new(from: &Corner, to: &Corner) -> Self {
        let (dx, dy) = (i64::from(to.x - from.x), i64::from(to.y - from.y));
        Self { x: from.x.into(), y: from.y.into(), dx, dy }
    }

    /// Returns twice the signed area of the triangle that the edge forms with a point: positive
    /// inside.
    fn at(&self, x: i64, y: i64) -> i64 {
        self.dx * (y - self.y) - self.dy * (x - self.x)
    }

    /// Starts the edge at a row.
    #[inline(always)]
    fn walk(&self, row: i64) -> Walk {
        let at = self.at(PIXEL / 2, row * PIXEL + PIXEL / 2);
        self.walk_from(at, -self.dy * PIXEL, self.dx * PIXEL)
    }

    /// Starts the edge at a column; rows and columns change their roles.
    fn walk_column(&self, column: i64) -> Walk {
        let at = self.at(column * PIXEL + PIXEL / 2, PIXEL / 2);
        self.walk_from(at, self.dx * PIXEL, -self.dy * PIXEL)
    }

    /// Starts the edge at a row, given `at` for the row's first pixel and the changes of `at` to
    /// the next column and to the next row.
    #[inline(always)]
    fn walk_from(&self, at: i64, column: i64, row: i64) -> Walk {
        let owns = self.dy < 0 || (self.dy == 0 && self.dx > 0);
        let excluded = i64::from(!owns);
        // A horizontal edge crosses no row, so the column of its crossing is never used.
        let whole = column.abs().max(PIXEL);
        let reciprocal = 1.0 / whole as f64;
        let (columns, rest) = divided(at - excluded, whole, reciprocal);
        let (more_columns, more_rest) = divided(row, whole, reciprocal);
        Walk { at, column, row, excluded, whole, columns, rest, more_columns, more_rest }
    }
}

impl Walk {
    /// Narrows a range of columns to the columns whose centres are inside the edge.
    #[inline(always)]
    fn narrow(&self, start: &mut i64, end: &mut i64) {
        match self.column {
            0 if self.at < self.excluded => *end = *start,
            0 => {}
            1.. => *start = (*start).max(-self.columns),
            _ => *end = (*end).min(self.columns + 1),
        }
    }

    /// Steps to the next row.
    #[inline(always)]
    fn step(&mut self) {
        self.at += self.row;
        let rest = self.rest + self.more_rest;
        let carry = i64::from(rest >= self.whole);
        self.rest = rest - carry * self.whole;
        self.columns += self.more_columns + carry;
    }
}

/// Returns the quotient, rounded down, and the remainder of a division, given the reciprocal of the
/// divisor. The quotient from the product with the reciprocal is wrong by at most one; the function
/// corrects this error.
#[inline(always)]
fn divided(dividend: i64, divisor: i64, reciprocal: f64) -> (i64, i64) {
    let guess = (dividend as f64 * reciprocal) as i64;
    let rest = dividend - guess * divisor;
    let more = i64::from(rest >= divisor) - i64::from(rest < 0);
    (guess + more, rest - more * divisor)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fastrand::Rng;
    use glam::Vec3;

    const SIZE: usize = 16;

    fn corner(rng: &mut Rng) -> Corner {
        // A step of a quarter pixel is coarse enough for centres to lie on edges, where ties occur.
        let mut next = || rng.i32(0..=4 * SIZE as i32) * (PIXEL as i32 / 4);
        Corner { x: next(), y: next(), nearness: 1.0, normal: Vec3::Z }
    }

    /// Returns the pixels that a triangle of either winding covers.
    fn covered(a: Corner, b: Corner, c: Corner) -> Vec<bool> {
        let mut fragments = Fragments::new(SIZE, SIZE, Stripes::ALL).unwrap();
        fragments.draw([a, b, c], 1);
        fragments.draw([a, c, b], 1);
        fragments.material.iter().map(|&material| material != 0).collect()
    }

    #[test]
    fn triangles_that_share_an_edge_share_no_pixel_and_leave_none_out() {
        let mut rng = Rng::with_seed(7);
        let mut shared_edges_hit = 0;
        for _ in 0..20_000 {
            let [a, b, c, inner] = [0; 4].map(|_| corner(&mut rng));
            let whole = covered(a, b, c);
            let parts = [covered(a, b, inner), covered(b, c, inner), covered(c, a, inner)];
            let sum = |i: usize| parts.iter().filter(|part| part[i]).count();
            let sense =
                |a: Corner, b: Corner, c: Corner| Edge::new(&a, &b).at(c.x.into(), c.y.into()).signum();
            let senses = [sense(a, b, inner), sense(b, c, inner), sense(c, a, inner)];
            let is_inside = senses.iter().all(|&s| s == sense(a, b, c)) && senses[0] != 0;
            if is_inside {
                shared_edges_hit += 1;
                for (i, &is_covered) in whole.iter().enumerate() {
                    assert_eq!(sum(i), usize::from(is_covered), "pixel {i} of {a:?} {b:?} {c:?} {inner:?}");
                }
            }
        }
        assert!(shared_edges_hit > 500, "{shared_edges_hit} triangles were split");
    }
}
