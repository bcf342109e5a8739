//! Positions of points on the projected square of a light.

use luminaire::{
    Scalar, Vec3,
    projector::{CompiledProjection, Gobo, ProjectedPoint},
};

/// Projected points, each quantity in its own array.
#[derive(Clone, Debug)]
pub(crate) struct Places<S: Scalar, const N: usize> {
    column: [i32; N],
    row: [i32; N],
    depth: [S::Length; N],
}

impl<S: Scalar, const N: usize> Default for Places<S, N> {
    fn default() -> Self {
        Self { column: [0; N], row: [0; N], depth: [S::Length::default(); N] }
    }
}

impl<S: Scalar, const N: usize> Places<S, N> {
    /// Projects all points, in a loop that is vectorised.
    #[inline(never)]
    pub(crate) fn find(&mut self, square: &CompiledProjection<S>, points: &Vec3<[S::Length; N]>) {
        let Self { column, row, depth } = self;
        for i in 0..N {
            let place = square.place(Vec3::new(points.x[i], points.y[i], points.z[i]));
            column[i] = place.column;
            row[i] = place.row;
            depth[i] = place.depth;
        }
    }

    /// Returns the transmissions of a gobo on the square.
    pub(crate) fn transmissions(&self, gobo: Gobo<'_>) -> [S; N] {
        gobo.transmission_each(&self.column, &self.row)
    }

    /// Returns the projected point at an index.
    #[inline(always)]
    pub(crate) fn at(&self, i: usize) -> ProjectedPoint<S> {
        ProjectedPoint { column: self.column[i], row: self.row[i], depth: self.depth[i] }
    }
}
