//! Change of a plane's nearness within a texel.

use crate::raster::view::{NEAR, Seen};
use glam::Vec3;
use luminaire::Scalar;

/// Largest distance in metres between a tested point and its surface. Points of a G-buffer have an
/// error because corners are rounded to 1/256 of a pixel. This error is largest on surfaces seen at
/// a grazing angle. Points in fixed point also have an error of half a quantum.
const POINT_ERROR: f32 = 2e-4;

/// Largest position error of a projected corner, in texels.
const CORNER_ERROR: f32 = 1.0 / 256.0;

/// Largest rounding error of an interpolated nearness, relative to the largest nearness of its
/// triangle.
const ROUNDING: f32 = 1e-6;

/// Cosine of the angle of incidence below which the back faces of a solid are drawn.
///
/// These faces may be needed around the outline of the solid. Pictures of the example scenes with
/// this limit differ from pictures with all back faces in two pixels, by 8 codes at most. Without
/// any back faces the outlines of shadows are ragged.
const EDGE_ON: f32 = 0.4;

/// Returns the largest position error of a projected point, in sides of the square.
///
/// `tests/bounds.csv` contains the measured values.
pub(super) fn place_error<S: Scalar>(tangent: f32) -> f32 {
    (2.0 + tangent) * S::STEP + S::DIRECTION_ERROR / tangent + 1.0 / 65_536.0
}

/// Returns the largest relative error of a point's depth.
pub(super) fn depth_error<S: Scalar>(tangent: f32) -> f32 {
    (3.0 + 2.0 * tangent) * S::STEP
}

/// Constants for all triangles of a map.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slope {
    /// Tangent of half the angle of the square.
    tangent: f32,
    /// Largest distance between a point and the centre of a texel whose depth is compared with the
    /// point, in half sides of the square.
    reach: f32,
}

impl Slope {
    pub(super) fn new<S: Scalar>(tangent: f32, side: usize) -> Self {
        let texels = (1.0 + CORNER_ERROR) / side as f32;
        Self { tangent, reach: 2.0 * (texels + place_error::<S>(tangent)) }
    }

    /// Returns whether the light sees the back of a triangle that is not nearly edge-on.
    ///
    /// Nearly edge-on back faces are needed: around the outline of a solid, these faces fill the
    /// texels where the front faces are too steep.
    pub(super) fn is_turned_away(&self, corners: [&Seen; 3]) -> bool {
        let [a, b, c] =
            corners.map(|seen| Vec3::new(seen.x * self.tangent, seen.y * self.tangent, seen.depth));
        let normal = (b - a).cross(c - a);
        // Right, up and forward are left-handed here: the normal of a front face points forward.
        let height = normal.dot(a);
        height < 0.0 && height * height > EDGE_ON * EDGE_ON * normal.length_squared() * a.length_squared()
    }

    /// Returns an upper bound of the decrease of a triangle's nearness within a texel.
    ///
    /// The decrease is from the centre of the texel to any point that is compared with the texel,
    /// in the plane of the triangle. The result is infinite for a plane through the light.
    ///
    /// The nearness of a plane is linear on the map: `n.r / n.a` along the vector `r` to depth 1,
    /// for a normal `n` of any length and a point `a` of the plane. The coordinates are scaled so
    /// that the square has a side of 2.
    pub(super) fn within_texel(&self, corners: [&Seen; 3]) -> f32 {
        let [a, b, c] = corners.map(|seen| Vec3::new(seen.x, seen.y, seen.depth));
        let normal = (b - a).cross(c - a);
        let height = normal.dot(a).abs();
        let nearest = 1.0 / a.z.min(b.z).min(c.z).max(NEAR);
        let across = normal.x.abs() + normal.y.abs();
        // Upper bound of the length of the normal in world coordinates.
        let length = across / self.tangent + normal.z.abs();
        (across * self.reach + length * nearest * POINT_ERROR) / height + nearest * ROUNDING
    }
}
