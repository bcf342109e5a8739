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
            let place = square.project(Vec3::new(points.x[i], points.y[i], points.z[i]));
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

#[cfg(test)]
mod tests {
    use super::*;
    use core::array;

    /// On the square, at its corners and off it, for gobos of one transmission and of many.
    #[test]
    fn transmissions_equal_those_of_single_places() {
        let mut random = fastrand::Rng::with_seed(3);
        for side in [1, 2, 5, 64] {
            let transmissions: alloc::vec::Vec<u8> = (0..side * side).map(|_| random.u8(..)).collect();
            let gobo = Gobo::new(side, &transmissions).unwrap();
            for _ in 0..2_000 {
                let mut steps = || array::from_fn(|_| random.i32(-70_000..140_000));
                let places = Places::<f32, 8> { column: steps(), row: steps(), depth: [1.0; 8] };
                let each: [f32; 8] = array::from_fn(|i| gobo.transmission(&places.at(i)));
                assert_eq!(places.transmissions(gobo), each, "{side} {places:?}");
            }
        }
    }
}
