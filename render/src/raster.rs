//! Triangles to fragments: exact coverage, and the nearest fragment of each pixel.

use crate::{
    gbuffer::LANES,
    memory::filled,
    view::{Corner, SUBPIXEL_BITS},
};
use alloc::{collections::TryReserveError, vec::Vec};

/// One pixel in steps of a screen coordinate.
const PIXEL: i64 = 1 << SUBPIXEL_BITS;

/// The pixels of a picture. Rows are filled up to their stride.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) stride: usize,
}

/// Neighbouring pixels of a row that a triangle covers.
pub(crate) struct Span<'a> {
    /// Their numbers, row by row from the top.
    pub(crate) pixels: core::ops::Range<usize>,
    corners: [&'a Corner; 3],
    /// The shares of the second and the third corner: of the first pixel, and the change to the next.
    to_b: (f32, f32),
    to_c: (f32, f32),
}

impl Grid {
    /// Hands over what a triangle covers, row by row, if its corners follow each other against the clock:
    /// others are seen from behind and cover nothing.
    #[inline(always)]
    pub(crate) fn cover(&self, corners: &[Corner; 3], mut fill: impl FnMut(Span<'_>)) {
        // With y downwards the sense of rotation is reversed.
        let [a, c, b] = corners;
        let edges = [Edge::new(b, c), Edge::new(c, a), Edge::new(a, b)];
        let area = edges[2].at(i64::from(c.x), i64::from(c.y));
        if area <= 0 {
            return;
        }
        let ys = [a.y, b.y, c.y].map(i64::from);
        let (top, bottom) = (ys[0].min(ys[1]).min(ys[2]), ys[0].max(ys[1]).max(ys[2]));
        let first = first_center(top);
        let last = first_center(bottom + 1).min(self.height as i64);
        let share = 1.0 / area as f32;
        for y in first..last {
            let y_center = y * PIXEL + PIXEL / 2;
            let (mut start, mut end) = (0, self.width as i64);
            for edge in &edges {
                edge.narrow(y_center, &mut start, &mut end);
            }
            if start >= end {
                continue;
            }
            let x_center = start * PIXEL + PIXEL / 2;
            let weight = |edge: &Edge| {
                let (at, step) = (edge.at(x_center, y_center), edge.step() * PIXEL);
                (at as f32 * share, step as f32 * share)
            };
            let row = y as usize * self.stride;
            fill(Span {
                pixels: row + start as usize..row + end as usize,
                corners: [a, b, c],
                to_b: weight(&edges[1]),
                to_c: weight(&edges[2]),
            });
        }
    }
}

impl Span<'_> {
    /// A value of the corners along the pixels.
    #[inline(always)]
    pub(crate) fn line(&self, of: impl Fn(&Corner) -> f32) -> Line {
        let [a, b, c] = self.corners.map(of);
        Line {
            start: a + self.to_b.0 * (b - a) + self.to_c.0 * (c - a),
            step: self.to_b.1 * (b - a) + self.to_c.1 * (c - a),
        }
    }
}

/// The nearest fragment of each pixel. Rows are filled up to whole blocks of [`LANES`].
#[derive(Clone, Debug)]
pub(crate) struct Fragments {
    grid: Grid,
    /// The reciprocal of the depth; 0 where nothing was drawn.
    pub(crate) nearness: Vec<f32>,
    /// Normals of any length.
    pub(crate) normal: [Vec<f32>; 3],
    /// The number of the material; 0 where nothing was drawn.
    pub(crate) material: Vec<u32>,
}

impl Fragments {
    pub(crate) fn new(width: usize, height: usize) -> Result<Self, TryReserveError> {
        let stride = width.next_multiple_of(LANES);
        let count = stride * height;
        let plane = || filled(count, 0.0_f32);
        let normal = [plane()?, plane()?, plane()?];
        let grid = Grid { width, height, stride };
        Ok(Self { grid, nearness: plane()?, normal, material: filled(count, 0)? })
    }

    /// Removes all fragments.
    pub(crate) fn clear(&mut self) {
        self.nearness.fill(0.0);
        self.material.fill(0);
    }

    /// Draws a triangle where it is seen from the front and nearer than what is there.
    pub(crate) fn draw(&mut self, corners: [Corner; 3], material: u32) {
        let grid = self.grid;
        grid.cover(&corners, |span| {
            let nearness = span.line(|corner| corner.nearness);
            let normal = [0, 1, 2].map(|i| span.line(|corner| corner.normal[i]));
            self.fill(span.pixels, nearness, normal, material);
        });
    }

    /// Puts a span of fragments where they are nearer than what is there.
    fn fill(&mut self, span: core::ops::Range<usize>, nearness: Line, normal: [Line; 3], material: u32) {
        let [nx, ny, nz] = &mut self.normal;
        let planes = self.nearness[span.clone()]
            .iter_mut()
            .zip(&mut nx[span.clone()])
            .zip(&mut ny[span.clone()])
            .zip(&mut nz[span.clone()])
            .zip(&mut self.material[span]);
        for (i, ((((old, nx), ny), nz), old_material)) in planes.enumerate() {
            let new = nearness.at(i);
            if new > *old {
                *old = new;
                *nx = normal[0].at(i);
                *ny = normal[1].at(i);
                *nz = normal[2].at(i);
                *old_material = material;
            }
        }
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
        self.start + self.step * i as f32
    }
}

/// The first row or column whose centre is at or after a screen coordinate.
fn first_center(coordinate: i64) -> i64 {
    (coordinate + PIXEL / 2 - 1) >> SUBPIXEL_BITS
}

/// An edge of a triangle, which lies on its right on a screen whose y points down. All in exact integers.
struct Edge {
    x: i64,
    y: i64,
    dx: i64,
    dy: i64,
    /// 0 for a top or left edge, which owns the points on it; 1 for the others, which leave them to the
    /// neighbour.
    excluded: i64,
}

impl Edge {
    fn new(from: &Corner, to: &Corner) -> Self {
        let (dx, dy) = (i64::from(to.x - from.x), i64::from(to.y - from.y));
        let owns = dy < 0 || (dy == 0 && dx > 0);
        Self { x: from.x.into(), y: from.y.into(), dx, dy, excluded: i64::from(!owns) }
    }

    /// Twice the area of the triangle that the edge forms with a point: positive inside.
    fn at(&self, x: i64, y: i64) -> i64 {
        self.dx * (y - self.y) - self.dy * (x - self.x)
    }

    /// The change from a screen coordinate to the next along x.
    fn step(&self) -> i64 {
        -self.dy
    }

    /// Narrows a span of columns to those whose centres are inside, on the row with this centre.
    fn narrow(&self, y_center: i64, start: &mut i64, end: &mut i64) {
        let at_first = self.at(PIXEL / 2, y_center) - self.excluded;
        let step = self.step() * PIXEL;
        match step {
            0 if at_first < 0 => *end = *start,
            0 => {}
            1.. => *start = (*start).max(-at_first.div_euclid(step)),
            _ => *end = (*end).min(at_first.div_euclid(-step) + 1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    const SIZE: usize = 16;

    fn corner(seed: &mut u64) -> Corner {
        let mut next = || {
            *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            // A quarter of a pixel is coarse enough for centres to lie on edges, which is where ties are.
            ((*seed >> 33) % (4 * SIZE as u64 + 1)) as i32 * (PIXEL as i32 / 4)
        };
        Corner { x: next(), y: next(), nearness: 1.0, normal: Vec3::Z }
    }

    /// The pixels that a triangle covers, whichever way it turns.
    fn covered(a: Corner, b: Corner, c: Corner) -> Vec<bool> {
        let mut fragments = Fragments::new(SIZE, SIZE).unwrap();
        fragments.draw([a, b, c], 1);
        fragments.draw([a, c, b], 1);
        fragments.material.iter().map(|&material| material != 0).collect()
    }

    #[test]
    fn triangles_that_share_an_edge_share_no_pixel_and_leave_none_out() {
        let mut seed = 7;
        let mut shared_edges_hit = 0;
        for _ in 0..20_000 {
            let [a, b, c, inner] = [0; 4].map(|_| corner(&mut seed));
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
