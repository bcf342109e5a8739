//! The nearest surface in each texel, with a depth that prevents self-shadowing.

use crate::{
    buffer::filled,
    raster::{Grid, Span, faced, view::Corner},
    stripes::Stripes,
};
use alloc::{collections::TryReserveError, vec::Vec};
use luminaire::Scalar;

/// The depths that a light sees, with a border of one empty texel.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    grid: Grid,
    /// Nearness of the nearest surface; 0 where nothing was drawn.
    nearness: Vec<f32>,
    /// Nearness (reciprocal of the depth) below which a point in the texel is in shadow. The value
    /// is the maximum over all surfaces of the least nearness of a surface within the texel. The
    /// least nearness of an almost edge-on surface is so small that the surface behind determines
    /// the value.
    hiding: Vec<f32>,
    /// Result of the vertical pass for each texel of a row. The value is the least `hiding` of this
    /// texel and of the texels above and below on the same surface.
    column: Vec<f32>,
}

impl Layer {
    pub(super) fn new(side: usize) -> Result<Self, TryReserveError> {
        let stride = side + 2;
        let plane = || filled(stride * stride, 0.0_f32);
        Ok(Self {
            grid: Grid { width: side, height: side, stride, stripes: Stripes::ALL },
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

    /// Draws a triangle, front or back. `change` returns how much the triangle's nearness changes
    /// within a texel. `change` is called only if the triangle covers a texel.
    pub(super) fn draw(&mut self, corners: [Corner; 3], change: impl Fn() -> f32) {
        let grid = self.grid;
        let mut known = None;
        grid.cover(&faced(corners), |span| self.fill(&span, *known.get_or_insert_with(&change)));
    }

    #[inline(always)]
    fn fill(&mut self, span: &Span<'_>, change: f32) {
        let line = span.line(|corner| corner.nearness);
        // Skips the border row at the top and the border texel at the start of the row.
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

    /// Computes the depth of each texel: the largest depth of its surface in the 3 x 3 texels
    /// around it.
    ///
    /// The depth is multiplied by `factor`. `texel` is the width of a texel at depth 1. A step in
    /// depth of up to the width of a texel cannot be resolved, so both sides of such a step count
    /// as the same surface.
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

/// The values of a layer in one texel.
#[derive(Clone, Copy)]
struct Texel {
    nearness: f32,
    hiding: f32,
}

/// A surface's continuation into a neighbouring texel.
#[derive(Clone, Copy)]
struct End {
    /// Least nearness that the surface in the neighbour has if both texels show the same surface.
    joint: f32,
    /// Nearness that is assumed for the surface if the surface ends before the neighbour's centre.
    edge: f32,
}

impl Texel {
    /// Returns the continuation of the texel's surface into a neighbour.
    ///
    /// Where a round surface ends, its nearness falls by twice the change within a texel, as a
    /// parabola does.
    #[inline(always)]
    fn end(self, texel: f32) -> End {
        End { joint: self.hiding - self.nearness * texel, edge: 2.0 * self.hiding - self.nearness }
    }
}

impl End {
    /// Returns the smaller of `least` and the neighbour's `hiding`.
    ///
    /// If the neighbour shows a different surface and `hiding` is at most `edge`, `edge` replaces
    /// `hiding`.
    #[inline(always)]
    fn with(self, neighbor: Texel, hiding: f32, least: f32) -> f32 {
        let is_joined = 2.0 * neighbor.nearness - neighbor.hiding >= self.joint;
        let hiding = if is_joined | (self.edge < hiding) { hiding } else { self.edge };
        if hiding < least { hiding } else { least }
    }
}
