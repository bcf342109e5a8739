//! The nearest surface in each texel, as deep as it may count.

use crate::{
    memory::filled,
    raster::{Grid, Span, faced},
    view::Corner,
};
use alloc::{collections::TryReserveError, vec::Vec};
use luminaire::Scalar;

/// What a light sees, texel by texel, within a border of one texel in which nothing is drawn.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    grid: Grid,
    /// The nearness of what is nearest; 0 where nothing was drawn.
    nearness: Vec<f32>,
    /// The nearness up to which a texel hides what is behind: the most that any of its surfaces keeps within
    /// a texel. So one that is almost edge-on leaves it to what is behind.
    hiding: Vec<f32>,
    /// The least of it in each texel of a row and in those above and below that are of the same surface.
    column: Vec<f32>,
}

impl Layer {
    pub(super) fn new(side: usize) -> Result<Self, TryReserveError> {
        let stride = side + 2;
        let plane = || filled(stride * stride, 0.0_f32);
        Ok(Self {
            grid: Grid { width: side, height: side, stride },
            nearness: plane()?,
            hiding: plane()?,
            column: filled(stride, 0.0)?,
        })
    }

    /// Removes everything.
    pub(super) fn clear(&mut self) {
        self.nearness.fill(0.0);
        self.hiding.fill(0.0);
    }

    /// Draws a triangle, from whichever side it is seen. How much its nearness changes within a texel is
    /// asked for only if it covers one.
    pub(super) fn draw(&mut self, corners: [Corner; 3], change: impl Fn() -> f32) {
        let grid = self.grid;
        let mut known = None;
        grid.cover(&faced(corners), |span| self.fill(&span, *known.get_or_insert_with(&change)));
    }

    #[inline(always)]
    fn fill(&mut self, span: &Span<'_>, change: f32) {
        let line = span.line(|corner| corner.nearness);
        // Past the row of the border, and the texel of this row's.
        let first = self.grid.stride + 1;
        let texels = first + span.pixels.start..first + span.pixels.end;
        let planes = self.nearness[texels.clone()].iter_mut().zip(&mut self.hiding[texels]);
        for (i, (nearness, hiding)) in planes.enumerate() {
            let new = line.at(i);
            *nearness = if new > *nearness { new } else { *nearness };
            let least = new - change;
            *hiding = if least > *hiding { least } else { *hiding };
        }
    }

    /// Finds the depth of each texel: the largest that its surface has in the nine texels around it, and by
    /// this factor more. A texel has this width at depth 1; a surface may have steps of as much, for which a
    /// texel has no room.
    pub(super) fn resolve<S: Scalar>(&mut self, texel: f32, factor: f32, depths: &mut [S::Length]) {
        let Grid { width, stride, .. } = self.grid;
        let Self { nearness, hiding, column, .. } = self;
        let texels = |first: usize| {
            let planes = nearness[first..].iter().zip(&hiding[first..]);
            planes.map(|(&nearness, &hiding)| Texel { nearness, hiding })
        };
        for (row, depths) in depths.chunks_exact_mut(width).enumerate() {
            let [above, own, below] = [row, row + 1, row + 2].map(|row| texels(row * stride));
            for (((column, above), own), below) in column.iter_mut().zip(above).zip(own).zip(below) {
                let end = own.end(texel);
                *column = end.with(below, below.hiding, end.with(above, above.hiding, own.hiding));
            }
            let [left, own, right] = [0, 1, 2].map(|x| texels((row + 1) * stride + x));
            let columns = column.windows(3);
            for ((((depth, column), left), own), right) in
                depths.iter_mut().zip(columns).zip(left).zip(own).zip(right)
            {
                let end = own.end(texel);
                let hiding = end.with(right, column[2], end.with(left, column[0], column[1]));
                *depth = S::length(if hiding > 0.0 { factor / hiding } else { f32::INFINITY });
            }
        }
    }
}

/// What a layer has of a texel.
#[derive(Clone, Copy)]
struct Texel {
    nearness: f32,
    hiding: f32,
}

/// Where a surface may go on in a neighbouring texel.
#[derive(Clone, Copy)]
struct End {
    /// The nearness that it must come up to there.
    joint: f32,
    /// How near it still is if it ends before.
    edge: f32,
}

impl Texel {
    /// What is round falls off by twice its slope where it ends, as a parabola does.
    #[inline(always)]
    fn end(self, texel: f32) -> End {
        End { joint: self.hiding - self.nearness * texel, edge: 2.0 * self.hiding - self.nearness }
    }
}

impl End {
    /// The least nearness up to which is hidden, with that of a neighbour if its surface is the same.
    #[inline(always)]
    fn with(self, neighbor: Texel, hiding: f32, least: f32) -> f32 {
        let is_joined = 2.0 * neighbor.nearness - neighbor.hiding >= self.joint;
        let hiding = if is_joined | (self.edge < hiding) { hiding } else { self.edge };
        if hiding < least { hiding } else { least }
    }
}
