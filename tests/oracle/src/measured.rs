//! The light of a table over all directions.

use glam::DVec3;

use crate::Attenuation;

/// A table on an octahedron that is unfolded to a square. Its whole side has `size` samples; a folded table has those
/// of `y >= 0`, or of `x >= 0` and `y >= 0`, alone.
#[derive(Clone, Copy, Debug)]
pub struct Octahedron<'a> {
    /// The samples, row by row; 65,535 is 1.
    pub samples: &'a [u16],
    /// The number of samples of a whole side.
    pub size: usize,
    /// Whether x and whether y is folded.
    pub folds: [bool; 2],
}

impl Octahedron<'_> {
    /// The sample at a column and a row of the whole square.
    pub fn sample(&self, column: usize, row: usize) -> f64 {
        let middle = self.size / 2;
        let [i, j] = [(column, self.folds[0]), (row, self.folds[1])]
            .map(|(place, folds)| if folds { place.abs_diff(middle) } else { place });
        let columns = if self.folds[0] { middle + 1 } else { self.size };
        f64::from(self.samples[columns * j + i]) / 65_535.0
    }

    /// The place of a direction on the square from -1 to 1: a corner of the square is folded over an edge of the
    /// octahedron, in which the direction is mirrored in the plane of this edge.
    pub fn place(direction: DVec3) -> [f64; 2] {
        let on_octahedron = direction / direction.abs().element_sum();
        let DVec3 { x, y, z } = on_octahedron;
        if z >= 0.0 {
            return [x, y];
        }
        // As far beyond the edge |x| + |y| = 1 as the place is before it.
        let beyond = 1.0 - x.abs() - y.abs();
        [x + beyond.copysign(x), y + beyond.copysign(y)]
    }

    /// The direction of a place.
    pub fn direction([x, y]: [f64; 2]) -> DVec3 {
        let z = 1.0 - x.abs() - y.abs();
        let beyond = (-z).max(0.0);
        DVec3::new(x - beyond.copysign(x), y - beyond.copysign(y), z).normalize()
    }

    /// The bilinear intensity in a direction with components along side, front and axis.
    pub fn at(&self, direction: DVec3) -> f64 {
        let last = self.size - 2;
        let [(i, u), (j, v)] = Self::place(direction).map(|place| {
            let place = (place + 1.0) / 2.0 * (self.size - 1) as f64;
            let cell = (libm::floor(place) as usize).min(last);
            (cell, place - cell as f64)
        });
        let corner = |di: usize, dj: usize| {
            let weight = |share: f64, d: usize| if d == 1 { share } else { 1.0 - share };
            weight(u, di) * weight(v, dj) * self.sample(i + di, j + dj)
        };
        corner(0, 0) + corner(1, 0) + corner(0, 1) + corner(1, 1)
    }
}

/// A light with such a table.
#[derive(Clone, Copy, Debug)]
pub struct MeasuredLight<'a> {
    /// Its position.
    pub position: DVec3,
    /// The direction of its axis, of any length.
    pub axis: DVec3,
    /// A direction nearest to which the side is, of any length.
    pub side: DVec3,
    /// Its table.
    pub table: Octahedron<'a>,
    /// The intensity of a sample of 65,535.
    pub intensity: f64,
    /// The attenuation over the distance.
    pub attenuation: Attenuation,
}

impl MeasuredLight<'_> {
    /// The components of a direction along side, front and axis: for a light that points down, and with the side to the
    /// right, the front is up in the plan.
    pub fn local(&self, direction: DVec3) -> DVec3 {
        let axis = self.axis.normalize();
        let side = self.side.reject_from_normalized(axis).normalize();
        DVec3::new(direction.dot(side), direction.dot(side.cross(axis)), direction.dot(axis))
    }

    /// The light that arrives at a surface that faces the light.
    pub fn arriving(&self, point: DVec3) -> f64 {
        let way = point - self.position;
        self.intensity * self.table.at(self.local(way)) * self.attenuation.at(way.length())
    }

    /// The light that arrives at a surface point, by Lambert's cosine, capped at 1.
    pub fn irradiance(&self, point: DVec3, normal: DVec3) -> f64 {
        let to_light = (self.position - point).normalize();
        self.arriving(point) * to_light.dot(normal).clamp(0.0, 1.0)
    }
}
