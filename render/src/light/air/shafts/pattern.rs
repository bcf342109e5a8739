//! A gobo along a line.

use alloc::vec::Vec;
use glam::Vec3;
use luminaire::projector::{Gobo, Projection};

/// Steps of a line through the cone.
pub(super) const STEPS: usize = 256;

/// A gobo in the gate of a light, for look-ups in f32.
pub(super) struct Pattern {
    side: usize,
    /// The transmission between each texel and those to its right and below: the coefficients of 1, of
    /// the share to the right, of the share down, and of both.
    corners: Vec<[f32; 4]>,
    /// Vectors whose products with a direction are its coordinates in texels, times the depth.
    right: Vec3,
    down: Vec3,
    axis: Vec3,
}

impl Pattern {
    pub(super) fn new((gobo, square): &(Gobo<'_>, Projection)) -> Self {
        let (side, all) = (gobo.side(), gobo.transmissions());
        let next = |i: usize| (i + 1).min(side - 1);
        let at = |row: usize, column: usize| all.get(row * side + column).copied().unwrap_or_default();
        let corners = (0..side * side).map(|i| {
            let (row, column) = (i / side, i % side);
            let [a, b, c, d] =
                [(row, column), (row, next(column)), (next(row), column), (next(row), next(column))]
                    .map(|(row, column)| f32::from(at(row, column)) / 255.0);
            [a, b - a, c - a, (d - c) - (b - a)]
        });
        let scale = side as f32 / (2.0 * square.tangent());
        Self {
            side,
            corners: corners.collect(),
            right: Vec3::from(square.right()) * scale,
            down: Vec3::from(square.up()) * -scale,
            axis: square.axis().into(),
        }
    }

    /// Multiplies the light of the directions of a line by the transmissions there, which are those
    /// of [`Gobo::transmission`] but for the rounding.
    pub(super) fn filter(&self, nearest: Vec3, onward: Vec3, edge: f32, lights: &mut [f32; STEPS]) {
        let [from, to] =
            [nearest, onward].map(|way| [self.right, self.down, self.axis].map(|axis| way.dot(axis)));
        let (center, last) = (0.5 * self.side as f32 - 0.5, (self.side - 1) as f32);
        let (mut first, mut right, mut down) = ([0_i32; STEPS], [0.0; STEPS], [0.0; STEPS]);
        let within = |place: f32| {
            let place = if place > 0.0 { place } else { 0.0 };
            let place = if place < last { place } else { last };
            split(place)
        };
        for i in 0..STEPS {
            let v = edge * ((i as i32 as f32 + 0.5) * (2.0 / STEPS as f32) - 1.0);
            let (cos, sin) = (1.0 - v * v, 2.0 * v);
            let depth = 1.0 / (cos * from[2] + sin * to[2]);
            let (column, row);
            (column, right[i]) = within((cos * from[0] + sin * to[0]) * depth + center);
            (row, down[i]) = within((cos * from[1] + sin * to[1]) * depth + center);
            first[i] = row * self.side as i32 + column;
        }
        for i in 0..STEPS {
            let corners = self.corners.get(first[i] as usize).copied().unwrap_or_default();
            let [own, across, along, both] = corners;
            lights[i] *= (own + across * right[i]) + (along + both * right[i]) * down[i];
        }
    }
}

/// Divides a number from 0 to 2^22 into a whole number and the rest, from 0 to 1.
///
/// The sum with `1.5 * 2^23` has no bits for a fraction. A conversion to an integer would not be
/// vectorised on x86-64, where it takes ten times the instructions.
#[inline(always)]
pub(super) fn split(number: f32) -> (i32, f32) {
    const SHIFT: f32 = 12_582_912.0;
    let shifted = (number - 0.5) + SHIFT;
    (shifted.to_bits() as i32 - SHIFT.to_bits() as i32, number - (shifted - SHIFT))
}
