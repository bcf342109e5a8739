//! The cones in haze whose errors have bounds.

/// The half angles of the cones, in degrees.
pub const HALF_ANGLES: [f32; 6] = [0.1, 1.0, 7.5, 22.0, 45.0, 90.0];
