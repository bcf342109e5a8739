//! A beam as seen from the eye.

use super::{
    cell::{COLUMNS, Cell, ROWS},
    hazy::{Hazy, Way},
    rays::Fan,
};
use glam::Vec3;
use luminaire::Scalar;

/// A beam as seen from the eye, and the error that its light may have.
pub(super) struct Beam<'a, S: Scalar> {
    pub(super) hazy: &'a Hazy,
    pub(super) way: &'a Way<'a, S>,
    /// The largest error, before the colour.
    pub(super) tolerance: f32,
    /// The vector from the eye to the light.
    light: Vec3,
    /// The normals of the planes through the eye that touch the beam.
    sides: [Vec3; 2],
    /// The sine of half the angle between these planes, about the line between eye and light.
    turn: f32,
}

/// Number of steps between rays that must fit into the width of the beam, and between the rays and
/// the light.
///
/// An outline with a radius of `r` steps may bulge by `1 / (8 r)` steps between two rays, and the
/// light rises from 0 to full scale within `r` steps. So with 8 steps the bulge has at most half a
/// linear code.
const STEPS: f32 = 8.0;

/// Distance of a direction from a side of the beam that counts as beside the beam; see
/// [`sides`](luminaire::haze::BeamScattering::sides).
const MARGIN: f32 = 2e-5;

/// The sides of a beam in a tile: the distances of the rays' ends at depth 1 from them.
pub(super) struct Sides {
    /// The distance of the first pixel from each side, and its change per column and per row.
    sides: [[f32; 3]; 2],
    margin: f32,
}

impl Sides {
    /// Returns whether the rays through a pixel and the next `others` to its right are beside the
    /// beam.
    #[inline(always)]
    pub(super) fn is_beside(&self, (x, y): (usize, usize), others: usize) -> bool {
        self.sides.iter().any(|[first, column, row]| {
            let start = first + row * y as f32;
            [x, x + others].iter().all(|&x| start + column * (x as f32) < -self.margin)
        })
    }
}

impl<'a, S: Scalar> Beam<'a, S> {
    pub(super) fn new(hazy: &'a Hazy, way: &'a Way<'a, S>, fan: &Fan, tolerance: f32) -> Self {
        let sides = hazy.beam.sides(fan.eye.into()).map(Vec3::from);
        let is_outside = sides[0] != Vec3::ZERO;
        let turn = if is_outside { (sides[0] + sides[1]).length() / 2.0 } else { 1.0 };
        Self { hazy, way, tolerance, light: hazy.position - fan.eye, sides, turn }
    }

    /// Returns whether all rays through a cell are beside the beam.
    pub(super) fn is_beside(&self, fan: &Fan, cell: &Cell) -> bool {
        let side = cell.side();
        let corners = [(0, 0), (side, 0), (0, side), (side, side)];
        let ways = corners.map(|(x, y)| fan.at((cell.x + x) as f32, (cell.y + y) as f32));
        self.sides.iter().any(|normal| ways.iter().all(|way| way.dot(*normal) < -MARGIN * way.length()))
    }

    /// Returns the sides of the beam in a tile.
    pub(super) fn sides_of(&self, fan: &Fan) -> Sides {
        let sides = self.sides.map(|normal| fan.vectors().map(|way| way.dot(normal)));
        let corners = [(0, 0), (COLUMNS, 0), (0, ROWS), (COLUMNS, ROWS)];
        let lengths = corners.map(|(x, y)| fan.at(x as f32, y as f32).length());
        Sides { sides, margin: MARGIN * lengths.into_iter().fold(0.0, f32::max) }
    }

    /// Returns whether rays with an angle of `step` between them can't miss the beam.
    ///
    /// The rays are within the angle `around` of the direction `middle`. The planes through the eye
    /// and the light that meet the beam span at least `2 turn` radians. So the beam's width at a
    /// ray is at least `2 turn sin(beta)` radians, with the angle `beta` at the eye between the
    /// light and the ray. Towards the end of the beam, the width is that of the cone. Near the
    /// light, the in-scattering is proportional to `1 / sin(beta)`.
    pub(super) fn is_wide(&self, middle: Vec3, around: f32, step: f32) -> bool {
        let across = middle.cross(self.light).length();
        let beta = across / (middle.length() * self.light.length());
        // Behind the eye, the light is infinitely far from every ray.
        let beta = if middle.dot(self.light) > 0.0 { beta } else { 1.0 } - around;
        // Rays that hit the light end there.
        let beta = beta - self.hazy.radius / self.light.length();
        let versine = self.hazy.beam.outer_versine();
        let least = STEPS * step;
        // The squared sine of the outer angle.
        let squared = versine * (2.0 - versine);
        beta >= least && 2.0 * self.turn * beta >= least && 4.0 * squared >= least * least
    }
}
