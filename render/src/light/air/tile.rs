//! The air in front of a tile.

use super::{
    beam::{Beam, Seen},
    frame::WIDTH,
    hazy::{BATCH, Hazy, Way},
    rays::{Fan, Sides},
};
use crate::{
    buffer::LANES,
    raster::{Fragments, view::View},
    stripes::Stripes,
};
use core::ops::Range;
use luminaire::{Rgb, Scalar};

/// The in-scattered light at the pixels of a tile, row by row, in `f32` for every number format.
#[derive(Clone, Debug)]
pub(crate) struct Scattered {
    /// Scratch memory, of which only the lit rows are cleared.
    rows: [Rgb<[f32; LANES]>; Stripes::ROWS],
    is_lit: [bool; Stripes::ROWS],
}

impl Scattered {
    pub(crate) fn none() -> Self {
        let rows = core::array::from_fn(|_| Rgb::default().map(|()| [0.0; LANES]));
        Self { rows, is_lit: [false; Stripes::ROWS] }
    }

    /// Returns the light of a row, to add to it.
    fn row(&mut self, y: usize) -> &mut Rgb<[f32; LANES]> {
        let row = &mut self.rows[y];
        if !core::mem::replace(&mut self.is_lit[y], true) {
            *row = Rgb::default().map(|()| [0.0; LANES]);
        }
        row
    }

    /// Returns the light of each row; `None` where there is none.
    pub(crate) fn rows(&self) -> impl Iterator<Item = Option<&Rgb<[f32; LANES]>>> {
        self.rows.iter().zip(&self.is_lit).map(|(row, is_lit)| is_lit.then_some(row))
    }
}

/// The air in front of a tile.
pub(crate) struct TileAir<'a> {
    fan: Fan,
    fragments: &'a Fragments,
    /// The rows of the tile, and the column of its blocks.
    place: (Range<usize>, usize),
    /// The columns of the tile that are in the picture.
    columns: usize,
    light: &'a mut Scattered,
    /// Number of evaluated rays.
    rays: usize,
}

impl<'a> TileAir<'a> {
    /// Returns the air in front of the rows `place.0` of a column of blocks, of which `columns` pixels
    /// are in the picture. The light is written to `light`.
    pub(crate) fn new(
        view: &View,
        fragments: &'a Fragments,
        place: (Range<usize>, usize),
        columns: usize,
        light: &'a mut Scattered,
    ) -> Self {
        let fan = Fan::new(view, place.0.start, place.1);
        light.is_lit = [false; Stripes::ROWS];
        Self { fan, fragments, place, columns, light, rays: 0 }
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
            if lit.is_empty() {
                continue;
            }
            let Rgb { red, green, blue } = self.light.row(y);
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
