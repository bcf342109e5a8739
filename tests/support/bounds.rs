//! The one table of error bounds. Each is a measured largest error with a little headroom: a test fails when an
//! error grows past its bound, and also when the bound has become loose. All are searched, none is exhaustive.

use super::sweep::HALF_ANGLES;

/// The bounds of one profile in one format.
pub struct Row {
    pub profile: &'static str,
    pub format: &'static str,
    /// Versine to intensity: the kernel's own rounding, in steps of the format (`Scalar::STEP`).
    pub falloff: f64,
    /// Position to intensity, for each of [`HALF_ANGLES`].
    pub spot: Column,
    /// Position and normal to irradiance: Lambert and inverse square included, for a light that reaches full scale
    /// about where the point is, relative to the larger of full scale and the light on the axis there.
    pub lit: Column,
}

/// One error for each of [`HALF_ANGLES`]; [`REFUSE`] where the format refuses the cone.
pub type Column = [f64; HALF_ANGLES.len()];

/// The format refuses so narrow a cone.
pub const REFUSE: f64 = f64::INFINITY;

/// Degrees:  0.01     0.1      0.5      1        2        3.5      7.5      15       30       60       89
#[rustfmt::skip]
pub const ROWS: [Row; 54] = [
    Row {
        profile: "soft", format: "f32", falloff: 2.46,
        spot: [4.3e-4, 4.4e-5, 8.8e-6, 4.3e-6, 2.3e-6, 1.4e-6, 6.4e-7, 4.2e-7, 3.1e-7, 2.4e-7, 2.3e-7],
        lit:  [3.9e-4, 4.1e-5, 7.4e-6, 4.0e-6, 2.0e-6, 1.3e-6, 6.7e-7, 5.8e-7, 6.7e-7, 5.4e-7, 5.5e-7],
    },
    Row {
        profile: "soft", format: "fx32", falloff: 1.75,
        spot: [7.2e-6, 7.4e-7, 1.7e-7, 7.9e-8, 9.0e-8, 6.7e-8, 5.8e-8, 4.2e-8, 5.7e-9, 2.4e-9, 8.0e-9],
        lit:  [6.8e-6, 6.6e-7, 1.5e-7, 7.7e-8, 8.5e-8, 6.4e-8, 5.6e-8, 4.2e-8, 6.3e-9, 7.0e-9, 9.1e-9],
    },
    Row {
        profile: "soft", format: "fx16", falloff: 1.53,
        spot: [REFUSE, REFUSE, REFUSE, 1.1e-3, 6.2e-4, 3.8e-4, 2.7e-4, 2.1e-4, 2.0e-4, 1.4e-4, 1.6e-4],
        lit:  [REFUSE, REFUSE, REFUSE, 1.0e-3, 5.9e-4, 4.0e-4, 3.5e-4, 3.4e-4, 3.4e-4, 2.9e-4, 3.4e-4],
    },
    Row {
        profile: "hard", format: "f32", falloff: 1.18,
        spot: [REFUSE, 1.1e-4, 2.2e-5, 1.0e-5, 5.8e-6, 3.3e-6, 1.7e-6, 1.1e-6, 7.6e-7, 6.4e-7, 6.9e-7],
        lit:  [REFUSE, 9.5e-5, 1.8e-5, 9.5e-6, 4.8e-6, 2.8e-6, 1.5e-6, 9.9e-7, 6.3e-7, 5.4e-7, 5.4e-7],
    },
    Row {
        profile: "hard", format: "fx32", falloff: 1.5,
        spot: [1.8e-5, 2.0e-6, 4.4e-7, 2.1e-7, 3.1e-7, 2.4e-7, 2.2e-7, 1.6e-7, 1.8e-8, 4.9e-9, 3.0e-8],
        lit:  [1.6e-5, 1.7e-6, 4.1e-7, 1.9e-7, 2.9e-7, 2.3e-7, 2.1e-7, 1.6e-7, 1.7e-8, 6.7e-9, 2.9e-8],
    },
    Row {
        profile: "hard", format: "fx16", falloff: 1.61,
        spot: [REFUSE, REFUSE, REFUSE, REFUSE, 3.3e-5, 1.1e-3, 7.1e-4, 5.6e-4, 5.3e-4, 3.8e-4, 4.4e-4],
        lit:  [REFUSE, REFUSE, REFUSE, REFUSE, 3.3e-5, 9.1e-4, 6.3e-4, 4.6e-4, 4.4e-4, 3.0e-4, 3.7e-4],
    },
    Row {
        profile: "linear", format: "f32", falloff: 1.13,
        spot: [5.5e-4, 5.3e-5, 1.1e-5, 5.2e-6, 3.0e-6, 1.7e-6, 8.8e-7, 5.4e-7, 4.0e-7, 3.4e-7, 3.4e-7],
        lit:  [4.8e-4, 4.9e-5, 9.2e-6, 4.8e-6, 2.4e-6, 1.5e-6, 7.4e-7, 5.7e-7, 5.7e-7, 5.3e-7, 4.7e-7],
    },
    Row {
        profile: "linear", format: "fx32", falloff: 1.15,
        spot: [9.0e-6, 1.0e-6, 2.3e-7, 1.1e-7, 1.6e-7, 1.3e-7, 1.1e-7, 8.1e-8, 9.4e-9, 2.8e-9, 1.5e-8],
        lit:  [8.3e-6, 8.4e-7, 2.1e-7, 9.5e-8, 1.5e-7, 1.2e-7, 1.1e-7, 8.0e-8, 8.7e-9, 5.6e-9, 1.5e-8],
    },
    Row {
        profile: "linear", format: "fx16", falloff: 1.08,
        spot: [REFUSE, REFUSE, REFUSE, 3.3e-5, 7.6e-4, 5.1e-4, 3.5e-4, 2.7e-4, 2.6e-4, 1.9e-4, 2.2e-4],
        lit:  [REFUSE, REFUSE, REFUSE, 3.3e-5, 7.3e-4, 4.8e-4, 3.3e-4, 3.0e-4, 3.1e-4, 3.1e-4, 3.1e-4],
    },
    Row {
        profile: "cut-off", format: "f32", falloff: 0.0,
        spot: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        lit:  [5.5e-7, 5.2e-7, 5.4e-7, 5.5e-7, 5.5e-7, 5.2e-7, 5.4e-7, 5.3e-7, 5.2e-7, 5.1e-7, 5.4e-7],
    },
    Row {
        profile: "cut-off", format: "fx32", falloff: 0.0,
        spot: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        lit:  [6.0e-9, 6.1e-9, 5.7e-9, 5.5e-9, 6.2e-9, 5.5e-9, 5.6e-9, 5.6e-9, 5.6e-9, 5.8e-9, 5.7e-9],
    },
    Row {
        profile: "cut-off", format: "fx16", falloff: 0.0,
        spot: [REFUSE, REFUSE, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        lit:  [REFUSE, REFUSE, 3.0e-4, 3.1e-4, 3.1e-4, 3.7e-4, 3.1e-4, 3.1e-4, 3.3e-4, 3.5e-4, 3.1e-4],
    },
    Row {
        profile: "smooth", format: "f32", falloff: 1.8,
        spot: [6.0e-4, 6.4e-5, 1.3e-5, 6.3e-6, 3.3e-6, 2.0e-6, 9.6e-7, 5.7e-7, 3.9e-7, 3.5e-7, 3.6e-7],
        lit:  [5.3e-4, 5.6e-5, 1.1e-5, 5.3e-6, 2.8e-6, 1.7e-6, 8.3e-7, 5.3e-7, 5.3e-7, 5.1e-7, 5.3e-7],
    },
    Row {
        profile: "smooth", format: "fx32", falloff: 1.87,
        spot: [1.1e-5, 1.1e-6, 2.5e-7, 1.2e-7, 1.5e-7, 1.2e-7, 1.0e-7, 7.4e-8, 9.8e-9, 3.4e-9, 1.5e-8],
        lit:  [9.3e-6, 1.1e-6, 2.3e-7, 1.1e-7, 1.5e-7, 1.1e-7, 9.7e-8, 7.1e-8, 8.7e-9, 6.4e-9, 1.5e-8],
    },
    Row {
        profile: "smooth", format: "fx16", falloff: 1.8,
        spot: [REFUSE, REFUSE, REFUSE, REFUSE, 9.2e-4, 5.9e-4, 4.1e-4, 3.2e-4, 3.0e-4, 2.2e-4, 2.4e-4],
        lit:  [REFUSE, REFUSE, REFUSE, REFUSE, 8.7e-4, 5.5e-4, 3.7e-4, 3.3e-4, 3.3e-4, 3.5e-4, 3.4e-4],
    },
    Row {
        profile: "blend", format: "f32", falloff: 2.13,
        spot: [3.8e-4, 4.1e-5, 8.1e-6, 3.9e-6, 2.1e-6, 1.3e-6, 6.4e-7, 3.7e-7, 2.8e-7, 2.2e-7, 2.5e-7],
        lit:  [3.5e-4, 3.6e-5, 7.1e-6, 3.4e-6, 1.8e-6, 1.1e-6, 6.5e-7, 6.1e-7, 6.2e-7, 5.5e-7, 5.3e-7],
    },
    Row {
        profile: "blend", format: "fx32", falloff: 1.7,
        spot: [6.7e-6, 7.0e-7, 1.6e-7, 7.4e-8, 9.4e-8, 7.2e-8, 6.3e-8, 4.7e-8, 6.2e-9, 2.1e-9, 8.9e-9],
        lit:  [6.2e-6, 6.3e-7, 1.4e-7, 6.8e-8, 9.1e-8, 6.9e-8, 6.2e-8, 4.5e-8, 6.0e-9, 6.4e-9, 9.5e-9],
    },
    Row {
        profile: "blend", format: "fx16", falloff: 1.55,
        spot: [REFUSE, REFUSE, REFUSE, 1.1e-3, 5.9e-4, 3.9e-4, 2.6e-4, 2.0e-4, 2.0e-4, 1.4e-4, 1.6e-4],
        lit:  [REFUSE, REFUSE, REFUSE, 9.7e-4, 5.6e-4, 4.2e-4, 3.4e-4, 3.3e-4, 3.1e-4, 3.0e-4, 3.3e-4],
    },
    Row {
        profile: "cubic", format: "f32", falloff: 4.37,
        spot: [6.1e-4, 6.3e-5, 1.3e-5, 6.1e-6, 3.3e-6, 2.0e-6, 1.1e-6, 6.2e-7, 4.9e-7, 3.8e-7, 4.2e-7],
        lit:  [5.8e-4, 5.6e-5, 1.0e-5, 5.7e-6, 3.0e-6, 1.8e-6, 8.3e-7, 7.1e-7, 7.8e-7, 5.4e-7, 6.0e-7],
    },
    Row {
        profile: "cubic", format: "fx32", falloff: 2.92,
        spot: [1.1e-5, 1.3e-6, 2.7e-7, 1.3e-7, 2.0e-7, 1.5e-7, 1.4e-7, 1.0e-7, 1.1e-8, 3.1e-9, 1.9e-8],
        lit:  [9.6e-6, 1.1e-6, 2.6e-7, 1.1e-7, 1.8e-7, 1.5e-7, 1.3e-7, 9.7e-8, 1.1e-8, 7.2e-9, 1.8e-8],
    },
    Row {
        profile: "cubic", format: "fx16", falloff: 2.63,
        spot: [REFUSE, REFUSE, REFUSE, REFUSE, 9.2e-4, 6.3e-4, 4.1e-4, 3.2e-4, 3.3e-4, 2.5e-4, 2.8e-4],
        lit:  [REFUSE, REFUSE, REFUSE, REFUSE, 8.0e-4, 5.6e-4, 3.5e-4, 3.6e-4, 3.4e-4, 3.1e-4, 3.6e-4],
    },
    Row {
        profile: "power 4", format: "f32", falloff: 5.01,
        spot: [5.6e-4, 5.2e-5, 1.1e-5, 5.4e-6, 2.7e-6, 1.8e-6, 8.6e-7, 6.0e-7, 5.6e-7, 2.9e-7, 3.6e-7],
        lit:  [4.7e-4, 4.7e-5, 9.4e-6, 4.5e-6, 2.4e-6, 1.7e-6, 9.1e-7, 7.2e-7, 8.2e-7, 5.6e-7, 6.2e-7],
    },
    Row {
        profile: "power 4", format: "fx32", falloff: 3.43,
        spot: [8.8e-6, 9.2e-7, 2.0e-7, 9.6e-8, 8.8e-8, 6.4e-8, 5.2e-8, 3.8e-8, 6.4e-9, 3.5e-9, 7.6e-9],
        lit:  [8.1e-6, 8.0e-7, 1.8e-7, 8.5e-8, 8.5e-8, 5.9e-8, 4.9e-8, 3.6e-8, 7.1e-9, 7.5e-9, 8.9e-9],
    },
    Row {
        profile: "power 4", format: "fx16", falloff: 2.89,
        spot: [REFUSE, REFUSE, REFUSE, 3.3e-5, 8.0e-4, 4.7e-4, 3.4e-4, 2.8e-4, 2.5e-4, 2.2e-4, 2.0e-4],
        lit:  [REFUSE, REFUSE, REFUSE, 3.3e-5, 7.1e-4, 5.3e-4, 4.1e-4, 3.9e-4, 3.9e-4, 4.1e-4, 3.6e-4],
    },
    Row {
        profile: "power 15", format: "f32", falloff: 18.3,
        spot: [REFUSE, 9.1e-5, 1.9e-5, 9.7e-6, 5.1e-6, 3.8e-6, 2.1e-6, 1.7e-6, 2.1e-6, 8.3e-7, 1.3e-6],
        lit:  [REFUSE, 7.8e-5, 1.6e-5, 8.3e-6, 4.6e-6, 3.3e-6, 2.0e-6, 1.8e-6, 2.0e-6, 9.8e-7, 1.3e-6],
    },
    Row {
        profile: "power 15", format: "fx32", falloff: 12.0,
        spot: [1.6e-5, 1.7e-6, 3.3e-7, 1.7e-7, 1.2e-7, 7.8e-8, 5.8e-8, 4.2e-8, 1.2e-8, 1.1e-8, 1.1e-8],
        lit:  [1.5e-5, 1.4e-6, 3.0e-7, 1.6e-7, 1.1e-7, 7.4e-8, 5.2e-8, 3.8e-8, 1.3e-8, 1.4e-8, 1.1e-8],
    },
    Row {
        profile: "power 15", format: "fx16", falloff: 9.38,
        spot: [REFUSE, REFUSE, REFUSE, REFUSE, 3.3e-5, 3.3e-5, 7.7e-4, 6.7e-4, 6.4e-4, 6.3e-4, 5.1e-4],
        lit:  [REFUSE, REFUSE, REFUSE, REFUSE, 3.3e-5, 3.3e-5, 7.3e-4, 7.3e-4, 7.2e-4, 7.6e-4, 5.8e-4],
    },
    Row {
        profile: "rim 4", format: "f32", falloff: 1.77,
        spot: [REFUSE, 2.1e-4, 4.1e-5, 2.0e-5, 1.1e-5, 6.4e-6, 3.4e-6, 2.2e-6, 1.5e-6, 1.2e-6, 1.4e-6],
        lit:  [REFUSE, 1.9e-4, 3.4e-5, 1.9e-5, 9.6e-6, 5.5e-6, 2.8e-6, 2.0e-6, 1.2e-6, 1.1e-6, 1.1e-6],
    },
    Row {
        profile: "rim 4", format: "fx32", falloff: 2.96,
        spot: [3.5e-5, 4.0e-6, 8.6e-7, 4.2e-7, 6.2e-7, 4.8e-7, 4.4e-7, 3.2e-7, 3.5e-8, 9.2e-9, 5.9e-8],
        lit:  [3.1e-5, 3.3e-6, 8.1e-7, 3.5e-7, 5.7e-7, 4.5e-7, 4.1e-7, 3.1e-7, 3.2e-8, 8.0e-9, 5.5e-8],
    },
    Row {
        profile: "rim 4", format: "fx16", falloff: 2.90,
        spot: [REFUSE, REFUSE, REFUSE, REFUSE, REFUSE, REFUSE, 3.3e-5, 1.1e-3, 9.6e-4, 7.6e-4, 8.0e-4],
        lit:  [REFUSE, REFUSE, REFUSE, REFUSE, REFUSE, REFUSE, 3.3e-5, 9.4e-4, 8.0e-4, 5.6e-4, 7.3e-4],
    },
    Row {
        profile: "integer power 15", format: "f32", falloff: 18.3,
        spot: [REFUSE, 9.1e-5, 1.9e-5, 9.7e-6, 5.1e-6, 3.8e-6, 2.1e-6, 1.7e-6, 2.1e-6, 8.3e-7, 1.3e-6],
        lit:  [REFUSE, 7.8e-5, 1.6e-5, 8.3e-6, 4.6e-6, 3.3e-6, 2.0e-6, 1.8e-6, 2.0e-6, 9.8e-7, 1.3e-6],
    },
    Row {
        profile: "integer power 15", format: "fx32", falloff: 12.0,
        spot: [1.6e-5, 1.7e-6, 3.3e-7, 1.7e-7, 1.2e-7, 7.8e-8, 5.8e-8, 4.2e-8, 1.2e-8, 1.1e-8, 1.1e-8],
        lit:  [1.5e-5, 1.4e-6, 3.0e-7, 1.6e-7, 1.1e-7, 7.4e-8, 5.2e-8, 3.8e-8, 1.3e-8, 1.4e-8, 1.1e-8],
    },
    Row {
        profile: "integer power 15", format: "fx16", falloff: 9.38,
        spot: [REFUSE, REFUSE, REFUSE, REFUSE, 3.3e-5, 3.3e-5, 7.7e-4, 6.7e-4, 6.3e-4, 6.3e-4, 5.1e-4],
        lit:  [REFUSE, REFUSE, REFUSE, REFUSE, 3.3e-5, 3.3e-5, 7.6e-4, 7.3e-4, 7.2e-4, 7.6e-4, 5.8e-4],
    },
    Row {
        profile: "integer rim 4", format: "f32", falloff: 1.77,
        spot: [REFUSE, 2.1e-4, 4.1e-5, 2.0e-5, 1.1e-5, 6.4e-6, 3.4e-6, 2.2e-6, 1.5e-6, 1.2e-6, 1.4e-6],
        lit:  [REFUSE, 1.9e-4, 3.4e-5, 1.9e-5, 9.6e-6, 5.5e-6, 2.8e-6, 2.0e-6, 1.2e-6, 1.1e-6, 1.1e-6],
    },
    Row {
        profile: "integer rim 4", format: "fx32", falloff: 2.96,
        spot: [3.5e-5, 4.0e-6, 8.6e-7, 4.2e-7, 6.2e-7, 4.8e-7, 4.4e-7, 3.2e-7, 3.5e-8, 9.2e-9, 5.9e-8],
        lit:  [3.1e-5, 3.3e-6, 8.1e-7, 3.5e-7, 5.7e-7, 4.5e-7, 4.1e-7, 3.1e-7, 3.2e-8, 8.0e-9, 5.5e-8],
    },
    Row {
        profile: "integer rim 4", format: "fx16", falloff: 2.89,
        spot: [REFUSE, REFUSE, REFUSE, REFUSE, REFUSE, REFUSE, 3.3e-5, 1.1e-3, 9.9e-4, 7.6e-4, 8.0e-4],
        lit:  [REFUSE, REFUSE, REFUSE, REFUSE, REFUSE, REFUSE, 3.3e-5, 9.4e-4, 8.3e-4, 5.6e-4, 7.3e-4],
    },
    Row {
        profile: "mixed power", format: "f32", falloff: 8.25,
        spot: [4.3e-4, 4.2e-5, 8.3e-6, 4.4e-6, 2.3e-6, 1.7e-6, 9.0e-7, 7.6e-7, 9.0e-7, 3.7e-7, 5.7e-7],
        lit:  [3.6e-4, 3.7e-5, 7.2e-6, 3.7e-6, 2.1e-6, 1.6e-6, 9.5e-7, 9.9e-7, 1.1e-6, 6.2e-7, 8.1e-7],
    },
    Row {
        profile: "mixed power", format: "fx32", falloff: 5.6,
        spot: [7.2e-6, 7.4e-7, 1.5e-7, 7.5e-8, 9.8e-8, 7.5e-8, 6.8e-8, 5.0e-8, 6.3e-9, 4.7e-9, 9.5e-9],
        lit:  [6.3e-6, 6.6e-7, 1.4e-7, 6.9e-8, 9.1e-8, 7.1e-8, 6.6e-8, 5.0e-8, 9.0e-9, 8.5e-9, 9.6e-9],
    },
    Row {
        profile: "mixed power", format: "fx16", falloff: 4.42,
        spot: [REFUSE, REFUSE, REFUSE, 3.3e-5, 6.6e-4, 4.5e-4, 3.4e-4, 3.0e-4, 2.7e-4, 3.1e-4, 2.4e-4],
        lit:  [REFUSE, REFUSE, REFUSE, 3.3e-5, 6.8e-4, 4.9e-4, 4.9e-4, 4.4e-4, 4.2e-4, 4.5e-4, 4.0e-4],
    },
    Row {
        profile: "mixed rim", format: "f32", falloff: 1.43,
        spot: [REFUSE, 1.3e-4, 2.7e-5, 1.3e-5, 7.3e-6, 4.1e-6, 2.2e-6, 1.4e-6, 9.6e-7, 8.2e-7, 8.8e-7],
        lit:  [REFUSE, 1.2e-4, 2.3e-5, 1.2e-5, 6.1e-6, 3.5e-6, 1.8e-6, 1.3e-6, 8.3e-7, 6.5e-7, 6.9e-7],
    },
    Row {
        profile: "mixed rim", format: "fx32", falloff: 2.27,
        spot: [2.3e-5, 2.6e-6, 5.6e-7, 2.7e-7, 4.0e-7, 3.1e-7, 2.8e-7, 2.1e-7, 2.3e-8, 6.2e-9, 3.8e-8],
        lit:  [2.0e-5, 2.2e-6, 5.2e-7, 2.3e-7, 3.7e-7, 2.9e-7, 2.7e-7, 2.0e-7, 2.1e-8, 6.2e-9, 3.6e-8],
    },
    Row {
        profile: "mixed rim", format: "fx16", falloff: 2.43,
        spot: [REFUSE, REFUSE, REFUSE, REFUSE, REFUSE, 1.3e-3, 8.9e-4, 7.0e-4, 6.5e-4, 4.7e-4, 5.5e-4],
        lit:  [REFUSE, REFUSE, REFUSE, REFUSE, REFUSE, 1.3e-3, 7.8e-4, 6.2e-4, 5.2e-4, 3.8e-4, 4.8e-4],
    },
    Row {
        profile: "table", format: "f32", falloff: 2.34,
        spot: [REFUSE, 9.4e-5, 1.9e-5, 9.7e-6, 5.1e-6, 2.9e-6, 1.5e-6, 8.6e-7, 6.2e-7, 5.9e-7, 6.2e-7],
        lit:  [REFUSE, 8.3e-5, 1.8e-5, 8.1e-6, 4.3e-6, 2.5e-6, 1.3e-6, 7.6e-7, 5.6e-7, 5.3e-7, 5.0e-7],
    },
    Row {
        profile: "table", format: "fx32", falloff: 1.69,
        spot: [1.6e-5, 1.7e-6, 3.8e-7, 1.8e-7, 2.4e-7, 1.8e-7, 1.6e-7, 1.2e-7, 1.5e-8, 4.5e-9, 2.2e-8],
        lit:  [1.5e-5, 1.6e-6, 3.6e-7, 1.6e-7, 2.3e-7, 1.7e-7, 1.6e-7, 1.2e-7, 1.3e-8, 6.1e-9, 2.2e-8],
    },
    Row {
        profile: "table", format: "fx16", falloff: 1.87,
        spot: [REFUSE, REFUSE, REFUSE, REFUSE, 4.0e-5, 8.4e-4, 6.3e-4, 4.4e-4, 4.0e-4, 3.0e-4, 3.5e-4],
        lit:  [REFUSE, REFUSE, REFUSE, REFUSE, 3.8e-5, 7.6e-4, 5.4e-4, 4.1e-4, 4.4e-4, 3.1e-4, 3.3e-4],
    },
    Row {
        profile: "soft, hotspot", format: "f32", falloff: 2.94,
        spot: [7.7e-4, 7.7e-5, 1.6e-5, 7.6e-6, 4.1e-6, 2.5e-6, 1.3e-6, 9.0e-7, 5.0e-7, 4.7e-7, 4.9e-7],
        lit:  [6.9e-4, 7.3e-5, 1.3e-5, 6.9e-6, 3.5e-6, 2.1e-6, 1.3e-6, 8.2e-7, 5.5e-7, 5.7e-7, 5.8e-7],
    },
    Row {
        profile: "soft, hotspot", format: "fx32", falloff: 1.72,
        spot: [1.3e-5, 1.3e-6, 3.0e-7, 1.6e-7, 1.3e-7, 1.2e-7, 8.7e-8, 8.3e-8, 5.5e-8, 7.5e-9, 3.0e-8],
        lit:  [1.2e-5, 1.2e-6, 2.6e-7, 1.6e-7, 1.3e-7, 1.1e-7, 8.4e-8, 8.0e-8, 5.2e-8, 5.9e-9, 3.3e-8],
    },
    Row {
        profile: "soft, hotspot", format: "fx16", falloff: 1.37,
        spot: [REFUSE, REFUSE, REFUSE, REFUSE, 1.1e-3, 7.4e-4, 4.5e-4, 3.4e-4, 3.3e-4, 2.6e-4, 2.9e-4],
        lit:  [REFUSE, REFUSE, REFUSE, REFUSE, 1.1e-3, 6.7e-4, 4.8e-4, 3.7e-4, 3.6e-4, 3.3e-4, 3.5e-4],
    },
    Row {
        profile: "soft, delimited", format: "f32", falloff: 2.49,
        spot: [4.3e-4, 4.4e-5, 8.8e-6, 4.3e-6, 2.3e-6, 1.4e-6, 6.4e-7, 4.2e-7, 3.1e-7, 2.4e-7, 2.3e-7],
        lit:  [3.9e-4, 4.1e-5, 7.4e-6, 4.0e-6, 2.0e-6, 1.3e-6, 6.7e-7, 5.8e-7, 6.7e-7, 5.4e-7, 5.5e-7],
    },
    Row {
        profile: "soft, delimited", format: "fx32", falloff: 1.76,
        spot: [7.2e-6, 7.4e-7, 1.7e-7, 7.9e-8, 9.0e-8, 6.7e-8, 5.8e-8, 4.2e-8, 5.7e-9, 2.4e-9, 8.0e-9],
        lit:  [6.8e-6, 6.6e-7, 1.5e-7, 7.7e-8, 8.5e-8, 6.4e-8, 5.6e-8, 4.2e-8, 6.3e-9, 7.0e-9, 9.1e-9],
    },
    Row {
        profile: "soft, delimited", format: "fx16", falloff: 1.53,
        spot: [REFUSE, REFUSE, REFUSE, 1.1e-3, 6.2e-4, 3.8e-4, 2.5e-4, 1.8e-4, 1.7e-4, 1.4e-4, 1.6e-4],
        lit:  [REFUSE, REFUSE, REFUSE, 1.0e-3, 5.9e-4, 4.0e-4, 3.5e-4, 3.4e-4, 3.4e-4, 2.9e-4, 3.4e-4],
    },
    Row {
        profile: "OpenGL 15", format: "f32", falloff: 6.85,
        spot: [2.4e-7, 4.7e-7, 5.7e-7, 8.0e-7, 8.0e-7, 8.0e-7, 8.3e-7, 8.4e-7, 8.3e-7, 8.0e-7, 7.9e-7],
        lit:  [7.8e-7, 8.9e-7, 9.1e-7, 1.1e-6, 1.1e-6, 1.1e-6, 1.1e-6, 1.1e-6, 9.8e-7, 1.1e-6, 9.4e-7],
    },
    Row {
        profile: "OpenGL 15", format: "fx32", falloff: 10.5,
        spot: [7.4e-9, 7.6e-9, 9.9e-9, 1.0e-8, 1.1e-8, 1.1e-8, 1.1e-8, 1.1e-8, 1.1e-8, 1.1e-8, 1.1e-8],
        lit:  [1.3e-8, 1.3e-8, 1.4e-8, 1.4e-8, 1.4e-8, 1.4e-8, 1.4e-8, 1.4e-8, 1.4e-8, 1.4e-8, 1.4e-8],
    },
    Row {
        profile: "OpenGL 15", format: "fx16", falloff: 9.14,
        spot: [REFUSE, REFUSE, 4.8e-4, 5.1e-4, 5.1e-4, 5.1e-4, 6.3e-4, 6.4e-4, 6.4e-4, 6.3e-4, 6.3e-4],
        lit:  [REFUSE, REFUSE, 6.9e-4, 6.9e-4, 7.0e-4, 6.9e-4, 6.8e-4, 7.2e-4, 6.7e-4, 6.6e-4, 6.4e-4],
    },
];

/// Whether a measured error keeps its bound, and the bound is not loose: the message says which way it broke. A cone
/// must be refused exactly where the table says so.
pub fn check(name: &str, measured: f64, bound: f64) -> Result<(), String> {
    // The bounds come from the long search, and the quick one sees fewer points.
    const LOOSE: f64 = 2.0;
    if measured > bound {
        Err(format!("{name}: the error is {measured:.2e}, over its bound of {bound:.2e}"))
    } else if bound > LOOSE * measured {
        Err(format!("{name}: the bound of {bound:.2e} is loose, the error is only {measured:.2e}"))
    } else {
        Ok(())
    }
}
