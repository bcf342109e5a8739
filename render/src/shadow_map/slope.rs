//! How much the nearness of a plane changes within a texel.

use crate::view::{NEAR, Seen};
use glam::Vec3;
use luminaire::Scalar;

/// How far off their surface the points may be that are asked for, in metres: a G-buffer's are off by what a
/// 256th of a pixel makes of a steep surface, and those of fixed point by half a quantum.
const POINT_ERROR: f32 = 2e-4;

/// How far off a corner may be on the map, in texels.
const CORNER_ERROR: f32 = 1.0 / 256.0;

/// How far off a nearness may be that is interpolated along a span, as a part of the largest of its triangle.
const ROUNDING: f32 = 1e-6;

/// The cosine under which a back is drawn, because it may be needed around an outline. With it the examples' pictures differ
/// from those of all backs in two pixels, by 8 codes at most; with none of them the outlines of shadows are ragged.
const EDGE_ON: f32 = 0.4;

/// How far off the place of a point may be, in sides of the square; `tests/support/squares.rs` has what is
/// measured.
fn place_error<S: Scalar>(tangent: f32) -> f32 {
    (2.0 + tangent) * S::STEP + S::DIRECTION_ERROR / tangent + 1.0 / 65_536.0
}

/// How far off its depth may be, relative.
pub(super) fn depth_error<S: Scalar>(tangent: f32) -> f32 {
    (3.0 + 2.0 * tangent) * S::STEP
}

/// What is the same for all triangles of a map.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slope {
    /// The tangent of half a side.
    tangent: f32,
    /// How far a point may be from the middle of the texel that it is compared with, in half sides of the
    /// square.
    reach: f32,
}

impl Slope {
    pub(super) fn new<S: Scalar>(tangent: f32, side: usize) -> Self {
        let texels = (1.0 + CORNER_ERROR) / side as f32;
        Self { tangent, reach: 2.0 * (texels + place_error::<S>(tangent)) }
    }

    /// Whether the light sees the back of a triangle, and by far not edge-on: around the outline of a solid its backs fill the
    /// texels that its fronts leave for being too steep.
    pub(super) fn is_turned_away(&self, corners: [&Seen; 3]) -> bool {
        let [a, b, c] =
            corners.map(|seen| Vec3::new(seen.x * self.tangent, seen.y * self.tangent, seen.depth));
        let normal = (b - a).cross(c - a);
        // To the right, up and ahead are left-handed: the normal of a front points ahead.
        let height = normal.dot(a);
        height < 0.0 && height * height > EDGE_ON * EDGE_ON * normal.length_squared() * a.length_squared()
    }

    /// By how much the nearness along the plane of a triangle may be less than in the middle of a texel that
    /// a point of it is compared with. Infinite for a plane that the light is in.
    ///
    /// The nearness of a plane is linear on the map: `n.r / n.a` along the way `r` to depth 1, for a normal
    /// `n` of any length and a point `a` of the plane. The square is two wide and two high here, whatever it
    /// is in the world.
    pub(super) fn within_texel(&self, corners: [&Seen; 3]) -> f32 {
        let [a, b, c] = corners.map(|seen| Vec3::new(seen.x, seen.y, seen.depth));
        let normal = (b - a).cross(c - a);
        let height = normal.dot(a).abs();
        let nearest = 1.0 / a.z.min(b.z).min(c.z).max(NEAR);
        let across = normal.x.abs() + normal.y.abs();
        // At least the length of the normal in the world.
        let length = across / self.tangent + normal.z.abs();
        (across * self.reach + length * nearest * POINT_ERROR) / height + nearest * ROUNDING
    }
}
