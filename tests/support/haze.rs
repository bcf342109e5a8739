//! The table of error bounds of in-scattering in haze. Errors are searched over 1,800 rays each,
//! and compared as in [`bounds`](super::bounds), two-sided.

/// The half angles of the cones, in degrees.
pub const HALF_ANGLES: [f32; 6] = [0.1, 1.0, 7.5, 22.0, 45.0, 90.0];

/// The bounds of one cone, distance model or number of samples, for each of [`HALF_ANGLES`].
pub struct Row {
    pub name: &'static str,
    pub errors: [f64; HALF_ANGLES.len()],
}

const fn row(name: &'static str, errors: [f64; HALF_ANGLES.len()]) -> Row {
    Row { name, errors }
}

/// The soft edge with another attenuation, along rays of up to 30 units.
#[rustfmt::skip]
pub const DISTANCES: [Row; 7] = [
    row("unattenuated",      [1.0e-3, 1.0e-3, 3.3e-3, 3.3e-3, 3.0e-2, 1.1e-2]),
    row("polynomial",        [1.0e-3, 7.2e-3, 6.0e-3, 5.2e-3, 9.9e-3, 7.3e-3]),
    row("smooth range",      [1.0e-3, 1.5e-3, 1.3e-3, 1.4e-3, 9.7e-3, 3.6e-3]),
    row("glTF range",        [7.0e-4, 2.2e-4, 3.6e-4, 2.7e-4, 8.8e-4, 2.3e-3]),
    row("Filament range",    [7.0e-4, 4.4e-4, 3.5e-4, 4.6e-4, 9.5e-4, 2.3e-3]),
    row("windowed",          [7.0e-4, 4.4e-4, 3.5e-4, 4.6e-4, 9.5e-4, 2.3e-3]),
    row("cut at",            [7.0e-4, 2.4e-4, 3.6e-4, 2.8e-4, 9.0e-4, 2.3e-3]),
];

/// The tolerances of the laws for rounding.
#[rustfmt::skip]
pub const LAWS: [(&str, f64); 7] = [
    ("largest fall",   1.5e-6),
    ("parts",          5.6e-4),
    ("turned",         1.2e-3),
    ("by 256 samples", 2.6e-5),
    ("beside the ray", 1.6e-6),
    ("direction",      1.8e-7),
    ("distance",       2.3e-7),
];

/// The soft edge along a million rays, half of them near critical directions
/// (`tests/slow/haze_search.rs`).
#[rustfmt::skip]
pub const CRITICAL: [Row; 2] = [
    row("inverse square",    [4.7e-5, 1.1e-5, 8.6e-6, 6.7e-6, 1.0e-5, 6.3e-6]),
    row("Filament range",    [1.2e-2, 1.5e-2, 1.5e-2, 1.5e-2, 1.4e-2, 3.0e-2]),
];
