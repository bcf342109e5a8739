//! The table of error bounds over every input, from a versine to the intensity: exhaustive, in
//! steps of the format, and two-sided as all of them. `LUMINAIRE_FULL=1 cargo test --test slow
//! exhaustive:: -- --nocapture` prints the measured ones.

use super::bounds::REFUSE;

/// The half angles in degrees of the cones.
pub const CONES: [f32; 4] = [0.01, 1.0, 15.0, 89.0];

/// The profiles that never rise towards the edge; the others do by a step at most.
pub const NEVER_RISE: [&str; 9] = [
    "soft",
    "hard",
    "linear",
    "power 4",
    "power 15",
    "rim 4",
    "integer power 15",
    "integer rim 4",
    "soft, hotspot",
];

/// The bounds of one profile in one format, for each of [`CONES`].
pub struct Row {
    pub profile: &'static str,
    pub format: &'static str,
    pub errors: [f64; CONES.len()],
}

const fn row(profile: &'static str, format: &'static str, errors: [f64; CONES.len()]) -> Row {
    Row { profile, format, errors }
}

/// Degrees:  0.01, 1, 15, 89
#[rustfmt::skip]
pub const ROWS: [Row; 23] = [
    row("soft",          "f32",  [1.77, 1.99, 1.70, 1.37]),
    row("hard",          "f32",  [REFUSE, 1.00, 0.92, 0.93]),
    row("smooth",        "f32",  [1.25, 1.38, 1.24, 1.29]),
    row("cubic",         "f32",  [3.11, 3.52, 2.98, 2.41]),
    row("soft",          "fx32", [1.52, 1.65, 1.72, 1.51]),
    row("hard",          "fx32", [1.47, 1.41, 1.47, 1.26]),
    row("smooth",        "fx32", [1.76, 1.78, 1.83, 1.67]),
    row("cubic",         "fx32", [2.53, 2.74, 2.88, 2.51]),
    row("soft",          "fx16", [REFUSE, 1.37, 1.40, 1.23]),
    row("hard",          "fx16", [REFUSE, REFUSE, 1.52, 1.28]),
    row("linear",        "fx16", [REFUSE, 0.51, 1.03, 0.91]),
    row("smooth",        "fx16", [REFUSE, REFUSE, 1.71, 1.55]),
    row("blend",         "fx16", [REFUSE, 1.41, 1.45, 1.31]),
    row("cubic",         "fx16", [REFUSE, REFUSE, 2.34, 2.04]),
    row("power 4",       "fx16", [REFUSE, 0.51, 2.63, 2.30]),
    row("power 15",      "fx16", [REFUSE, REFUSE, 8.96, 7.09]),
    row("rim 4",         "fx16", [REFUSE, REFUSE, 2.72, 2.44]),
    row("table",         "fx16", [REFUSE, REFUSE, 1.83, 1.57]),
    row("soft, hotspot", "fx16", [REFUSE, REFUSE, 1.26, 1.34]),
    row("integer power 15", "fx16", [REFUSE, REFUSE, 8.96, 7.09]),
    row("integer rim 4", "fx16", [REFUSE, REFUSE, 2.72, 2.44]),
    row("mixed power", "fx16", [REFUSE, 0.51, 3.74, 3.19]),
    row("mixed rim", "fx16", [REFUSE, REFUSE, 2.13, 2.01]),
];

/// The roundings of the profiles alone in `Fx32`, over every fraction.
#[rustfmt::skip]
pub const FRACTIONS: [(&str, f64); 10] = [
    ("soft",     0.5),
    ("hard",     0.5),
    ("linear",   0.5),
    ("smooth",   1.26),
    ("blend",    0.76),
    ("cubic",    0.79),
    ("power 4",  1.0),
    ("power 15", 3.56),
    ("rim 4",    1.0),
    ("table",    0.51),
];
