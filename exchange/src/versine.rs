//! The versine, 1 - cos, of a half angle in radians.

/// Returns the versine of a half angle.
pub(crate) fn versine(half: f64) -> f64 {
    2.0 * (half / 2.0).sin().powi(2)
}

/// Returns the half angle of a versine, at most a quarter turn.
pub(crate) fn of_versine(versine: f64) -> f64 {
    2.0 * (versine.min(1.0) / 2.0).sqrt().asin()
}
