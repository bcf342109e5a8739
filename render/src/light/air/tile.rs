//! The air in front of a tile.

use super::{
    beam::{Beam, Seen},
    frame::WIDTH,
    hazy::{BATCH, Hazy, Way},
    rays::{Fan, Sides},
};
use crate::{
    buffer::Radiance,
    raster::{Fragments, view::View},
};
use core::ops::Range;
use luminaire::{Rgb, Scalar};

/// The air in front of a tile.
pub(crate) struct TileAir<'a> {
    fan: Fan,
    fragments: &'a Fragments,
    /// The rows of the tile, and the column of its blocks.
    place: (Range<usize>, usize),
    /// The columns of the tile that are in the picture.
    columns: usize,
    /// The light of the tile's rows, whose blocks are `stride` apart.
    radiance: &'a mut [Radiance],
    stride: usize,
    /// Number of evaluated rays.
    rays: usize,
}

impl<'a> TileAir<'a> {
    /// Returns the air in front of the rows `place.0` of a column of blocks, of which `columns` pixels
    /// are in the picture. `radiance` begins with the block of the first row; the blocks of the next
    /// rows are `stride` apart.
    pub(crate) fn new(
        view: &View,
        fragments: &'a Fragments,
        place: (Range<usize>, usize),
        columns: usize,
        radiance: &'a mut [Radiance],
        stride: usize,
    ) -> Self {
        let fan = Fan::new(view, place.0.start, place.1);
        Self { fan, fragments, place, columns, radiance, stride, rays: 0 }
    }

    /// Adds the in-scattered light of a beam between its sides: by its formula, by its shafts, or with rays
    /// of the kernel.
    pub(crate) fn add<S: Scalar>(&mut self, hazy: &Hazy, way: &Way<'_, S>, beam: &Beam) {
        let sides = self.fan.sides(&beam.sides);
        match &beam.seen {
            Seen::Open(open) => {
                let sheaf = open.frame.sheaf(&self.fan);
                let run = open.way(&sheaf);
                self.add_runs(&sides, hazy.color, |_, at, nearness: &[_; WIDTH]| {
                    run(open, &sheaf, at, nearness)
                });
            }
            Seen::Shafts(shafts) => {
                let sheaf = shafts.frame.sheaf(&self.fan);
                self.add_runs(&sides, hazy.color, |_, at, nearness| shafts.light(&sheaf, at, nearness));
            }
            Seen::Rays => self.add_rays(hazy, way, &sides),
        }
    }

    /// Adds the in-scattered light of a beam, with a ray of the kernel through every pixel.
    pub(crate) fn add_each<S: Scalar>(&mut self, hazy: &Hazy, way: &Way<'_, S>) {
        self.add_rays(hazy, way, &Sides::NONE);
    }

    fn add_rays<S: Scalar>(&mut self, hazy: &Hazy, way: &Way<'_, S>, sides: &Sides) {
        self.add_runs(sides, hazy.color, |fan, at, nearness| {
            let mut light = [0.0; BATCH];
            hazy.scatter(&fan.rays(at, nearness), way, &mut light);
            light
        });
    }

    /// Adds the light of runs of `N` pixels between the sides of a beam.
    #[inline(always)]
    fn add_runs<const N: usize>(
        &mut self,
        sides: &Sides,
        color: Rgb<f32>,
        light: impl Fn(&Fan, (usize, usize), &[f32; N]) -> [f32; N],
    ) {
        let (rows, column) = self.place.clone();
        for (y, row) in rows.enumerate() {
            let block = self.fragments.block(row, column);
            let lit = sides.columns(y, self.columns);
            let Rgb { red, green, blue } = &mut self.radiance[y * self.stride];
            for x in (lit.start / N * N..lit.end).step_by(N) {
                let Some(nearness) = block[x..].first_chunk() else { continue };
                let lights = light(&self.fan, (x, y), nearness);
                for (channel, color) in
                    [(&mut *red, color.red), (&mut *green, color.green), (&mut *blue, color.blue)]
                {
                    for (sum, light) in channel[x..x + N].iter_mut().zip(&lights) {
                        *sum += light * color;
                    }
                }
                self.rays += N.min(self.columns - x);
            }
        }
    }

    /// Returns the number of evaluated rays.
    pub(crate) fn finish(self) -> usize {
        self.rays
    }
}
