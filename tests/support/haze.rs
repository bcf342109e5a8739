//! The table of error bounds of air light in haze, measured and held as in [`bounds`](super::bounds), two-sided and
//! searched.

/// The half angles of the cones, in degrees.
pub const HALF_ANGLES: [f32; 6] = [0.1, 1.0, 7.5, 22.0, 45.0, 90.0];

/// The bounds of one cone or distance model.
pub struct Row {
    pub name: &'static str,
    pub errors: [f64; HALF_ANGLES.len()],
}

/// Degrees: 0.1, 1, 7.5, 22, 45, 90
#[rustfmt::skip]
pub const CONES: [Row; 0] = [
];

pub const DISTANCES: [Row; 0] = [];
pub const SAMPLES: [Row; 0] = [];
pub const AT_THE_LAMP: [Row; 0] = [];
