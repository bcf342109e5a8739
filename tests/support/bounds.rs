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
pub const ROWS: [Row; 6] = [
    Row {
        profile: "soft", format: "f32", falloff: 2.5,
        spot: [4.4e-4, 4.4e-5, 9.0e-6, 4.4e-6, 2.3e-6, 1.4e-6, 6.5e-7, 4.3e-7, 3.1e-7, 2.4e-7, 2.3e-7],
        lit:  [4.0e-4, 4.2e-5, 7.5e-6, 4.0e-6, 2.0e-6, 1.3e-6, 6.8e-7, 5.8e-7, 6.7e-7, 5.5e-7, 5.6e-7],
    },
    Row {
        profile: "hard", format: "f32", falloff: 1.2,
        spot: [1.1e-3, 1.1e-4, 2.2e-5, 1.1e-5, 5.9e-6, 3.3e-6, 1.7e-6, 1.1e-6, 7.7e-7, 6.5e-7, 7.0e-7],
        lit:  [9.7e-4, 9.7e-5, 1.9e-5, 9.7e-6, 4.9e-6, 2.8e-6, 1.5e-6, 1.1e-6, 6.4e-7, 5.4e-7, 5.5e-7],
    },
    Row {
        profile: "soft", format: "fx32", falloff: 2.3,
        spot: [7.3e-6, 7.5e-7, 1.7e-7, 8.0e-8, 9.1e-8, 6.8e-8, 5.9e-8, 4.3e-8, 6.1e-9, 2.6e-9, 8.5e-9],
        lit:  [6.9e-6, 6.7e-7, 1.5e-7, 7.8e-8, 8.7e-8, 6.4e-8, 5.7e-8, 4.2e-8, 6.7e-9, 6.5e-9, 9.4e-9],
    },
    Row {
        profile: "hard", format: "fx32", falloff: 2.05,
        spot: [1.9e-5, 2.1e-6, 4.5e-7, 2.2e-7, 3.2e-7, 2.5e-7, 2.3e-7, 1.7e-7, 1.9e-8, 5.6e-9, 3.1e-8],
        lit:  [1.6e-5, 1.7e-6, 4.1e-7, 1.9e-7, 3.0e-7, 2.4e-7, 2.1e-7, 1.6e-7, 1.7e-8, 6.8e-9, 3.0e-8],
    },
    Row {
        profile: "soft", format: "fx16", falloff: 2.6,
        spot: [REFUSE, REFUSE, REFUSE, 1.2e-3, 6.1e-4, 3.8e-4, 2.6e-4, 2.0e-4, 1.8e-4, 1.7e-4, 1.6e-4],
        lit:  [REFUSE, REFUSE, REFUSE, 1.1e-3, 5.2e-4, 3.6e-4, 3.5e-4, 3.2e-4, 3.4e-4, 3.4e-4, 3.4e-4],
    },
    Row {
        profile: "hard", format: "fx16", falloff: 2.0,
        spot: [REFUSE, REFUSE, REFUSE, REFUSE, 1.5e-3, 9.9e-4, 5.5e-4, 4.7e-4, 4.4e-4, 4.4e-4, 4.2e-4],
        lit:  [REFUSE, REFUSE, REFUSE, REFUSE, 1.2e-3, 7.6e-4, 4.4e-4, 4.6e-4, 3.4e-4, 3.9e-4, 4.2e-4],
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
