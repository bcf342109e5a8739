//! How much the depth of a plane changes within a texel.

use crate::view::{NEAR, Seen};
use glam::Vec3;

/// How far off their surface the points may be that are asked for, in metres: a G-buffer's are off by what a 256th of
/// a pixel makes of a steep surface, and those of fixed point by half a quantum.
const POINT_ERROR: f32 = 2e-4;

/// How far off a place may be, in 65,536ths of a side, and a corner on the map, in texels.
const PLACE_ERROR: f32 = 6.0;
const CORNER_ERROR: f32 = 1.0 / 256.0;

/// How far off a nearness may be that is interpolated along a span, as a part of the largest of its triangle.
const ROUNDING: f32 = 1e-6;

/// What is the same for all triangles of a map.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slope {
    /// How far a point may be from the middle of the texel that it is compared with, in half sides of the square.
    reach: f32,
    /// The tangent of half a side.
    tangent: f32,
}

impl Slope {
    pub(super) fn new(tangent: f32, side: usize) -> Self {
        let texel = 2.0 / side as f32;
        let reach = texel * (1.0 + CORNER_ERROR) + 2.0 * PLACE_ERROR / 65_536.0;
        Self { reach, tangent }
    }

    /// By how much the nearness along the plane of a triangle may be less than in the middle of a texel whose answer counts:
    /// infinite for a plane that the light is in.
    ///
    /// The nearness of a plane is linear on the map: `n.r / n.a` along the way `r` to depth 1, for a normal `n` of any length
    /// and a point `a` of the plane.
    pub(super) fn within_texel(&self, [a, b, c]: [&Seen; 3]) -> f32 {
        let place = |seen: &Seen| Vec3::new(seen.x, seen.y, seen.depth);
        let (a, b, c) = (place(a), place(b), place(c));
        let normal = (b - a).cross(c - a).abs();
        let across = normal.x + normal.y;
        let height = (b - a).cross(c - a).dot(a).abs();
        let nearest = 1.0 / a.z.min(b.z).min(c.z).max(NEAR);
        // The square is two wide in these coordinates, whatever it is in the world.
        let length = across / self.tangent + normal.z;
        (across * self.reach + length * (POINT_ERROR * nearest)) / height + nearest * ROUNDING
    }
}
