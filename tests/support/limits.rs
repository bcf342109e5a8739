//! The table of the errors that a user sees, from an exact position and axis to the display, in
//! 8-bit codes; and the errors that the rounding of the inputs alone causes.

use super::bounds::REFUSE;
use super::oracle::{self, Cone};
use luminaire::Scalar;
use std::fmt::Write;

/// The half angles in degrees of the cones.
pub const CONES: [f32; 7] = [0.01, 0.1, 1.0, 3.5, 7.5, 30.0, 89.0];

/// The distance of the point from the light, and the largest coordinates of the light and of the
/// point.
pub const DISTANCE: f64 = 3.0;
pub const LIGHT_WITHIN: f64 = 4.0;
pub const POINT_WITHIN: f64 = 8.0;

/// One number for each of [`CONES`].
pub type Column = [f64; CONES.len()];

/// The bounds of one falloff in one format. Errors are searched and compared as in
/// [`bounds`](super::bounds), two-sided.
pub struct Row {
    pub falloff: &'static str,
    pub format: &'static str,
    /// Bounds of the linear intensity, in 1/255.
    pub linear: Column,
    /// Bounds of the displayed sRGB code, against the exact code before rounding: half a code of it
    /// is that rounding.
    pub codes: Column,
}

/// Degrees:  0.01, 0.1, 1, 3.5, 7.5, 30, 89
#[rustfmt::skip]
pub const ROWS: [Row; 12] = [
    Row {
        falloff: "soft", format: "f32",
        linear: [0.45, 4.6e-2, 4.7e-3, 1.5e-3, 6.0e-4, 1.6e-4, 7.7e-5],
        codes:  [1.1, 0.553, 0.511, 0.508, 0.508, 0.508, 0.508],
    },
    Row {
        falloff: "soft", format: "fx32",
        linear: [19.0, 1.9, 0.20, 5.1e-2, 2.4e-2, 6.1e-3, 2.1e-3],
        codes:  [30.0, 3.2, 0.78, 0.564, 0.535, 0.511, 0.508],
    },
    Row {
        falloff: "soft", format: "fx16",
        linear: [REFUSE, REFUSE, 0.39, 0.13, 8.1e-2, 5.1e-2, 4.1e-2],
        codes:  [REFUSE, REFUSE, 1.2, 0.74, 0.68, 0.66, 0.66],
    },
    Row {
        falloff: "hard", format: "f32",
        linear: [REFUSE, 0.11, 1.1e-2, 2.9e-3, 1.4e-3, 3.6e-4, 2.2e-4],
        codes:  [REFUSE, 1.5, 0.565, 0.520, 0.510, 0.508, 0.508],
    },
    Row {
        falloff: "hard", format: "fx32",
        linear: [42.0, 4.3, 0.45, 0.13, 5.9e-2, 1.5e-2, 4.0e-3],
        codes:  [120.0, 34.0, 5.2, 1.8, 1.2, 0.65, 0.533],
    },
    Row {
        falloff: "hard", format: "fx16",
        linear: [REFUSE, REFUSE, REFUSE, 0.33, 0.20, 0.13, 0.11],
        codes:  [REFUSE, REFUSE, REFUSE, 3.7, 2.6, 2.1, 1.6],
    },
    Row {
        falloff: "smooth", format: "f32",
        linear: [0.61, 6.3e-2, 6.3e-3, 2.0e-3, 8.6e-4, 2.5e-4, 1.2e-4],
        codes:  [1.6, 0.62, 0.513, 0.509, 0.508, 0.508, 0.508],
    },
    Row {
        falloff: "smooth", format: "fx32",
        linear: [27.0, 2.6, 0.27, 7.8e-2, 3.7e-2, 8.6e-3, 2.9e-3],
        codes:  [45.0, 4.9, 0.96, 0.65, 0.554, 0.515, 0.508],
    },
    Row {
        falloff: "smooth", format: "fx16",
        linear: [REFUSE, REFUSE, REFUSE, 0.18, 0.13, 7.9e-2, 6.7e-2],
        codes:  [REFUSE, REFUSE, REFUSE, 0.93, 0.82, 0.77, 0.78],
    },
    Row {
        falloff: "cubic", format: "f32",
        linear: [0.56, 5.9e-2, 6.2e-3, 1.8e-3, 8.1e-4, 2.1e-4, 1.4e-4],
        codes:  [6.7, 1.2, 0.538, 0.516, 0.510, 0.508, 0.508],
    },
    Row {
        falloff: "cubic", format: "fx32",
        linear: [23.0, 2.5, 0.27, 7.8e-2, 3.5e-2, 8.6e-3, 2.4e-3],
        codes:  [83.0, 26.0, 3.6, 1.4, 0.91, 0.61, 0.523],
    },
    Row {
        falloff: "cubic", format: "fx16",
        linear: [REFUSE, REFUSE, REFUSE, 0.20, 0.13, 8.1e-2, 7.2e-2],
        codes:  [REFUSE, REFUSE, REFUSE, 2.8, 1.9, 1.5, 1.3],
    },
];

/// Half the quantum of a coordinate of a given size.
fn half_quantum<S: Scalar>(size: f64) -> f64 {
    // The lengths of the fixed-point formats are I16F16.
    if S::NAME == "f32" { f64::from(f32::EPSILON) * size / 4.0 } else { 0.5_f64.powi(17) }
}

/// The largest angle in radians by which the rounding of the inputs alone turns the direction
/// relative to the axis. The inputs are three components each of a point, of a light, and of an
/// axis, which is f32 whatever the format.
pub fn input_rounding<S: Scalar>() -> f64 {
    let position = half_quantum::<S>(POINT_WITHIN) + half_quantum::<S>(LIGHT_WITHIN);
    let axis = 0.5_f64.powi(25);
    3.0_f64.sqrt() * (position / DISTANCE + axis)
}

/// The largest change of the linear intensity, in 1/255, and of the sRGB code, anywhere in a cone,
/// if every direction is turned outwards by `radians` and every versine is multiplied by
/// `1 + stretch`.
pub fn largest_change(cone: &Cone, half_degrees: f64, radians: f64, stretch: f64) -> [f64; 2] {
    let turn = radians.to_degrees();
    let change = |degrees: f64| {
        let near = cone.falloff(oracle::versine(degrees));
        let far = cone.falloff(oracle::versine(degrees + turn) * (1.0 + stretch));
        [255.0 * (near - far), oracle::srgb_code(near) - oracle::srgb_code(far)]
    };
    // Samples the whole cone, and more densely the part just before the edge, where codes change
    // most.
    let over = |from: f64| (0..=10_000).map(move |i| from + (half_degrees - from) * f64::from(i) / 10_000.0);
    let edge = (half_degrees - 10.0 * turn - half_degrees * stretch).max(0.0);
    over(0.0)
        .chain(over(edge))
        .map(change)
        .fold([0.0; 2], |worst, change| [worst[0].max(change[0]), worst[1].max(change[1])])
}

/// The block of the documentation: error and limit of every row. `limits` gives the limits of a
/// falloff in a format.
pub fn markdown(limits: impl Fn(&Row) -> [Column; 2]) -> String {
    let mut out = String::new();
    for (title, of) in [("linear, in 1/255", 0), ("sRGB codes", 1)] {
        let _ = write!(out, "| {title} |");
        for degrees in CONES {
            let _ = write!(out, " {degrees}° |");
        }
        let _ = write!(out, "\n|---|{}\n", "---|".repeat(CONES.len()));
        for row in &ROWS {
            let _ = write!(out, "| {} `{}` |", row.falloff, row.format);
            let (bounds, limits) = ([row.linear, row.codes][of], limits(row)[of]);
            for (bound, limit) in bounds.iter().zip(limits) {
                let cell = if *bound == REFUSE {
                    "refused".to_string()
                } else {
                    format!("{} / {}", short(*bound), short(limit))
                };
                let _ = write!(out, " {cell} |");
            }
            out.push('\n');
        }
        out.push('\n');
    }
    out
}

/// Formats a value with two digits, a small value with one.
fn short(value: f64) -> String {
    match value {
        0.0..0.001 => format!("{value:.0e}"),
        0.001..0.1 => format!("{value:.3}"),
        0.1..1.0 => format!("{value:.2}"),
        1.0..10.0 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}
