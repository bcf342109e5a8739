//! Half angles in radians: the versine, 1 - cos, and the full angle.

use luminaire::Angle;

/// Returns the versine of a half angle.
pub(crate) fn versine(half: f64) -> f64 {
    2.0 * (half / 2.0).sin().powi(2)
}

/// Returns the half angle of a versine, at most a quarter turn.
pub(crate) fn of_versine(versine: f64) -> f64 {
    2.0 * (versine.min(1.0) / 2.0).sqrt().asin()
}

/// Returns the full angle of a half angle, at most 180 degrees.
pub(crate) fn full(half: f64) -> Angle {
    Angle::degrees((2.0 * half.to_degrees()).min(180.0) as f32)
}
