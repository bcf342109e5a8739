//! The view rays through a tile, and a queue that evaluates them in batches.

use super::{
    ends::Ends,
    hazy::{BATCH, Hazy, Way},
};
use crate::{
    buffer::LANES,
    raster::{Fragments, view::View},
    space::vector,
};
use core::ops::Range;
use glam::Vec3;
use luminaire::{
    Scalar,
    haze::{RayBundle, ViewRays},
};

/// Largest number of rays in a queue: two ends at the nine nodes of each of four cells.
const MOST: usize = 2 * 9 * 4;

/// The rays from the eye through a tile's pixels.
///
/// A pixel has the coordinates of its centre, in pixels from the centre of the tile's first pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fan {
    pub(super) eye: Vec3,
    /// Vectors at depth 1: from the eye to the first pixel, to the next column and to the next row.
    first: Vec3,
    column: Vec3,
    row: Vec3,
}

/// Rays to evaluate, each as a pixel and the nearness of the ray's end.
pub(super) struct Queue {
    x: [f32; MOST],
    y: [f32; MOST],
    nearness: [f32; MOST],
    count: usize,
}

impl Fan {
    pub(super) fn new(view: &View, row: usize, column: usize) -> Self {
        let (first, across) = view.ray(row);
        Self { eye: view.eye(), first: first + across * column as f32, column: across, row: view.row() }
    }

    /// Returns the vectors at depth 1: from the eye to the first pixel, to the next column and to
    /// the next row.
    pub(super) fn vectors(&self) -> [Vec3; 3] {
        [self.first, self.column, self.row]
    }

    /// Returns the vector to a pixel at depth 1.
    #[inline(always)]
    pub(super) fn at(&self, x: f32, y: f32) -> Vec3 {
        self.first + self.column * x + self.row * y
    }

    /// Returns the bundle of the rays through a rectangle of pixels, up to this nearness.
    pub(super) fn bundle(&self, columns: Range<usize>, rows: Range<usize>, nearness: f32) -> RayBundle {
        let last = |range: &Range<usize>| range.end.saturating_sub(1);
        let [left, right] = [columns.start, last(&columns)].map(|x| x as f32);
        let [top, bottom] = [rows.start, last(&rows)].map(|y| y as f32);
        let corners = [(left, top), (right, top), (left, bottom), (right, bottom)];
        let ways = corners.map(|(x, y)| self.at(x, y));
        let directions = ways.map(vector::direction);
        let middle = vector::direction(directions.into_iter().sum());
        // The longest ray to depth 1 goes through a corner of the rectangle.
        let longest = ways.into_iter().map(vector::length).fold(0.0, f32::max);
        let directions = directions.map(Into::into);
        RayBundle::around(self.eye.into(), middle.into(), &directions, longest / nearness)
    }

    /// Returns an upper bound of the angle between the rays of neighbouring pixels, in radians.
    pub(super) fn pitch(&self) -> f32 {
        self.column.length().max(self.row.length())
    }
}

impl Queue {
    pub(super) const fn new() -> Self {
        Self { x: [0.0; MOST], y: [0.0; MOST], nearness: [0.0; MOST], count: 0 }
    }

    /// Adds the ray through a pixel, from the eye to this nearness. A nearness of 0 is a ray
    /// without an end.
    #[inline(always)]
    pub(super) fn push(&mut self, (x, y): (usize, usize), nearness: f32) {
        self.x[self.count] = x as f32;
        self.y[self.count] = y as f32;
        self.nearness[self.count] = nearness;
        self.count += 1;
    }

    /// Adds the rays through pixels up to the far end, and then up to the near end unless it is the
    /// same.
    pub(super) fn push_ends(
        &mut self,
        ends: &Ends,
        pixels: impl IntoIterator<Item = (usize, usize)> + Clone,
    ) {
        pixels.clone().into_iter().for_each(|pixel| self.push(pixel, ends.far.at(pixel)));
        if !ends.is_flat {
            pixels.into_iter().for_each(|pixel| self.push(pixel, ends.near.at(pixel)));
        }
    }

    /// Writes the in-scattered light of all rays, in the order in which they were added, and empties
    /// the queue. Returns the number of evaluated rays.
    pub(super) fn evaluate<S: Scalar>(
        &mut self,
        fan: &Fan,
        hazy: &Hazy,
        way: &Way<'_, S>,
        light: &mut [f32; MOST],
    ) -> usize {
        let count = core::mem::take(&mut self.count);
        // The last batch is filled up with the last ray.
        let whole = count.next_multiple_of(BATCH).min(MOST);
        for lane in count..whole {
            self.x[lane] = self.x[count - 1];
            self.y[lane] = self.y[count - 1];
            self.nearness[lane] = self.nearness[count - 1];
        }
        for first in (0..count).step_by(BATCH) {
            // The last batch may overlap the one before it.
            let first = first.min(MOST - BATCH);
            let rays = self.rays(fan, first);
            let mut batch = [0.0; BATCH];
            hazy.scatter(&rays, way, &mut batch);
            light[first..first + BATCH].copy_from_slice(&batch);
        }
        count
    }

    /// Returns the rays of a batch.
    #[inline(always)]
    fn rays(&self, fan: &Fan, from: usize) -> ViewRays<BATCH> {
        let none = [0.0; BATCH];
        let mut rays =
            ViewRays { eye: fan.eye.into(), direction: luminaire::Vec3::new(none, none, none), length: none };
        for lane in 0..BATCH {
            let (x, y) = (self.x[from + lane], self.y[from + lane]);
            let way = fan.at(x, y);
            let unit = vector::length(way);
            rays.direction.x[lane] = way.x / unit;
            rays.direction.y[lane] = way.y / unit;
            rays.direction.z[lane] = way.z / unit;
            // The ray to depth 1 has the length `unit`.
            rays.length[lane] = unit / self.nearness[from + lane];
        }
        rays
    }
}

/// Returns the bundle of all rays through a tile. The length of the bundle is the distance to the
/// farthest surface in the tile.
pub(crate) fn bundle(view: &View, fragments: &Fragments, rows: Range<usize>, column: usize) -> RayBundle {
    let fan = Fan::new(view, rows.start, column * LANES);
    let nearness = rows.clone().flat_map(|row| fragments.block(row, column));
    let least = nearness.copied().fold(f32::INFINITY, f32::min);
    fan.bundle(0..LANES, 0..rows.len(), least)
}

/// Room for the light of every ray in a queue.
pub(super) type Light = [f32; MOST];

pub(super) const NO_LIGHT: Light = [0.0; MOST];
