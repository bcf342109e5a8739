//! The nearest surface in each texel, as deep as it may count.

use crate::{
    memory::filled,
    raster::{Grid, Span},
    view::Corner,
};
use alloc::{collections::TryReserveError, vec::Vec};
use luminaire::Scalar;

/// What a light sees, texel by texel, within a border of one texel in which nothing is drawn.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    grid: Grid,
    /// The least nearness of the surface within a texel of the middle; 0 where nothing was drawn.
    least: Vec<f32>,
    /// By how much it is less than in the middle.
    drop: Vec<f32>,
    /// The least nearness of each texel of a row and of those above and below it.
    column: Vec<f32>,
}

impl Layer {
    pub(super) fn new(side: usize) -> Result<Self, TryReserveError> {
        let stride = side + 2;
        let plane = || filled(stride * stride, 0.0_f32);
        Ok(Self {
            grid: Grid { width: side, height: side, stride },
            least: plane()?,
            drop: plane()?,
            column: filled(stride, 0.0)?,
        })
    }

    /// Removes everything.
    pub(super) fn clear(&mut self) {
        self.least.fill(0.0);
        self.drop.fill(0.0);
    }

    /// Draws a triangle, from whichever side it is seen, where the least of its nearness within a texel is more than that of
    /// what is there. So what is so steep that it counts for hardly anything leaves the texel to what is behind it.
    pub(super) fn draw(&mut self, [a, b, c]: [Corner; 3], drop: f32) {
        let grid = self.grid;
        for side in [[a, b, c], [a, c, b]] {
            grid.cover(&side, |span| self.fill(&span, drop));
        }
    }

    fn fill(&mut self, span: &Span<'_>, drop: f32) {
        let nearness = span.line(|corner| corner.nearness);
        // Past the row of the border, and the texel of this row's.
        let first = self.grid.stride + 1;
        let texels = first + span.pixels.start..first + span.pixels.end;
        let planes = self.least[texels.clone()].iter_mut().zip(&mut self.drop[texels]);
        for (i, (old, old_drop)) in planes.enumerate() {
            let least = nearness.at(i) - drop;
            let is_nearer = least > *old;
            *old = if is_nearer { least } else { *old };
            *old_drop = if is_nearer { drop } else { *old_drop };
        }
    }

    /// Finds the depth of each texel: the largest that its surface has in the nine texels around it.
    pub(super) fn resolve<S: Scalar>(&mut self, depths: &mut [S::Length]) {
        let Self { grid, least, drop, column } = self;
        let rows = least.chunks_exact(grid.stride).zip(drop.chunks_exact(grid.stride));
        let (above, here, below) = (rows.clone(), rows.clone().skip(1), rows.skip(2));
        for (depths, ((above, here), below)) in
            depths.chunks_exact_mut(grid.width).zip(above.zip(here).zip(below))
        {
            let own = here.0.iter();
            let above = above.0.iter().zip(above.1);
            let below = below.0.iter().zip(below.1);
            for (((column, own), above), below) in column.iter_mut().zip(own).zip(above).zip(below) {
                let least = joined(*own, *own, above, *above.0);
                *column = joined(least, *own, below, *below.0);
            }
            let middle = here.0.windows(3).zip(here.1.windows(3));
            for ((depth, column), (own, drop)) in depths.iter_mut().zip(column.windows(3)).zip(middle) {
                let least = joined(column[1], own[1], (&own[0], &drop[0]), column[0]);
                let least = joined(least, own[1], (&own[2], &drop[2]), column[2]);
                *depth = S::length(if least > 0.0 { (1.0 + 4.0 * S::STEP) / least } else { f32::INFINITY });
            }
        }
    }
}

/// The lesser of two nearnesses if a neighbour can be of the same surface as a texel: if its nearness comes up to that of the
/// texel within one texel's width. What is farther behind is another surface.
#[inline(always)]
fn joined(least: f32, own: f32, (neighbor, drop): (&f32, &f32), candidate: f32) -> f32 {
    let is_joined = neighbor + 2.0 * drop >= own;
    if is_joined & (candidate < least) { candidate } else { least }
}
