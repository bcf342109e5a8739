//! The table of the errors that a user sees, from an exact position and axis to the display, in
//! 8-bit codes; and the errors that the rounding of the inputs alone causes.

use super::bounds::{self, REFUSE};
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

/// The falloffs that the tables have, each in every format.
pub const FALLOFFS: [&str; 4] = ["soft", "hard", "smooth", "cubic"];
pub const FORMATS: [&str; 3] = ["f32", "fx32", "fx16"];

/// The tables of bounds: of the linear intensity, in 1/255; and of the displayed sRGB code, against
/// the exact code before rounding: half a code of it is that rounding.
pub const TABLES: [&str; 2] = ["seen linear", "seen codes"];

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
pub fn markdown(limits: impl Fn(&str, &str) -> [Column; 2]) -> String {
    let mut out = String::new();
    for (of, title) in ["linear, in 1/255", "sRGB codes"].into_iter().enumerate() {
        let _ = write!(out, "| {title} |");
        for degrees in CONES {
            let _ = write!(out, " {degrees}° |");
        }
        let _ = write!(out, "\n|---|{}\n", "---|".repeat(CONES.len()));
        for (falloff, format) in FALLOFFS.iter().flat_map(|falloff| FORMATS.map(|format| (falloff, format))) {
            let _ = write!(out, "| {falloff} `{format}` |");
            let bounds = bounds::of(TABLES[of], falloff, format).expect("a row");
            for (bound, limit) in bounds.into_iter().zip(limits(falloff, format)[of]) {
                let cell = match bound {
                    REFUSE => "refused".to_string(),
                    _ => format!("{} / {}", short(bound), short(limit)),
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
