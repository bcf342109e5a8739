//! What `glam` does not have of vectors.

use glam::DVec3;

/// The nearest point of a grid of 2^-16, the quantum of many fixed-point lengths. Coordinates up to
/// 128 and their differences are exact there in f32 too, so that what is measured is the kernel and
/// not its input.
pub fn on_grid(v: impl Into<DVec3>) -> DVec3 {
    (v.into() * 65_536.0).round() / 65_536.0
}

/// A unit direction, turned towards another at right angles to it.
pub fn turned(from: DVec3, towards: DVec3, radians: f64) -> DVec3 {
    let (sine, cosine) = libm::sincos(radians);
    from * cosine + towards * sine
}
