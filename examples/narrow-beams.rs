//! Draws `docs/narrow-beams.svg`: the largest error of a soft spotlight over its half angle. It
//! shows the cosine form, and the versine form in each format with the narrowest beam that the
//! format supports.
//!
//! `cargo run --release --example narrow-beams > docs/narrow-beams.svg`. All errors are measured
//! against the tests' f64 reference. `tests/slow/limits.rs` checks the bounds of the lines.

use luminaire::{Fx16, Fx32};
use std::fmt::Write;
use support::{
    beams::{self, Errors},
    format::Format,
};

const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 600.0;
const LEFT: f64 = 84.0;
const RIGHT: f64 = 24.0;
const TOP: f64 = 64.0;
const BOTTOM: f64 = 62.0;

/// The corners of the picture as powers of ten.
const DEGREES: (i32, i32) = (-5, 2);
const ERRORS: (i32, i32) = (-9, 0);

const HALF_A_STEP: f64 = 1.0 / 510.0;

/// Number of points that are evaluated for each half angle.
const COUNT: usize = 20_000;

/// A format, its colour from Okabe and Ito's palette for colour-blind readers, and the half angles
/// in degrees at which its two lines are labelled.
struct Pen {
    name: &'static str,
    color: &'static str,
    cosine_named: f64,
    versine_named: f64,
}

fn x(degrees: f64) -> f64 {
    let decades = f64::from(DEGREES.1 - DEGREES.0);
    LEFT + (degrees.log10() - f64::from(DEGREES.0)) / decades * (WIDTH - LEFT - RIGHT)
}

fn y(error: f64) -> f64 {
    let decades = f64::from(ERRORS.1 - ERRORS.0);
    HEIGHT - BOTTOM - (error.log10() - f64::from(ERRORS.0)) / decades * (HEIGHT - TOP - BOTTOM)
}

fn text(out: &mut String, at: (f64, f64), attributes: &str, words: &str) {
    let _ = writeln!(out, r#"<text x="{:.1}" y="{:.1}" {attributes}>{words}</text>"#, at.0, at.1);
}

fn line(out: &mut String, points: &[(f64, f64)], attributes: &str) {
    let mut path = String::new();
    for (degrees, error) in points {
        let start = if path.is_empty() { "M" } else { " L" };
        let _ = write!(path, "{start}{:.1},{:.1}", x(*degrees), y(*error));
    }
    let _ = writeln!(out, r#"<path d="{path}" fill="none" {attributes}/>"#);
}

/// A power of ten as a label, with its unit.
fn power(exponent: i32, unit: &str) -> String {
    match exponent {
        0 => format!("1{unit}"),
        -3..0 => format!("{}{unit}", 10.0_f64.powi(exponent)),
        1.. => format!("{}{unit}", 10_i32.pow(exponent.cast_unsigned())),
        _ => format!(r#"10<tspan dy="-5" font-size="10">{exponent}</tspan><tspan dy="5">{unit}</tspan>"#),
    }
}

fn axes(out: &mut String) {
    for exponent in DEGREES.0..=DEGREES.1 {
        let degrees = 10.0_f64.powi(exponent);
        line(out, &[(degrees, 1e-9), (degrees, 1.0)], r##"stroke="#e4e4e4""##);
        text(out, (x(degrees), y(1e-9) + 20.0), r#"text-anchor="middle""#, &power(exponent, "°"));
    }
    for exponent in ERRORS.0..=ERRORS.1 {
        let error = 10.0_f64.powi(exponent);
        line(out, &[(1e-5, error), (100.0, error)], r##"stroke="#e4e4e4""##);
        text(out, (LEFT - 8.0, y(error) + 4.0), r#"text-anchor="end""#, &power(exponent, ""));
    }
    let middle = LEFT + (WIDTH - LEFT - RIGHT) / 2.0;
    text(out, (middle, HEIGHT - 14.0), r#"text-anchor="middle""#, "half angle of the cone");
    let upright = format!(r#"text-anchor="middle" transform="rotate(-90 20 {:.1})""#, HEIGHT / 2.0);
    text(out, (20.0, HEIGHT / 2.0), &upright, "largest error of the intensity, full scale is 1");
    line(out, &[(1e-5, HALF_A_STEP), (100.0, HALF_A_STEP)], r##"stroke="#555" stroke-width="1.5""##);
    text(out, (x(2.2), y(HALF_A_STEP) - 8.0), r##"fill="#555""##, "half an 8-bit step");
}

/// The measured lines of one format, the bound of the kernel's, and its narrowest beam.
fn format<S: Format>(out: &mut String, pen: &Pen) {
    let narrowest = beams::narrowest::<S>();
    let (from, to) = (10.0_f64.powi(DEGREES.0), 89.0_f64);
    let even = (0..=120).map(|i| from * (to / from).powf(f64::from(i) / 120.0));
    let mut half_angles: Vec<f64> = even.chain([narrowest * 1.000_01]).collect();
    half_angles.sort_by(f64::total_cmp);
    let found: Vec<Errors> =
        half_angles.into_iter().map(|half_degrees| beams::errors::<S>(half_degrees, COUNT)).collect();

    let color = pen.color;
    let cosine: Vec<_> = found.iter().map(|errors| (errors.half_degrees, errors.cosine_form)).collect();
    // Where the error is the whole intensity, the lines of the formats coincide. So each line
    // begins where its error becomes smaller.
    let begin = cosine.iter().rposition(|&(_, error)| error > 0.99).unwrap_or(0);
    line(out, &cosine[begin..], &format!(r#"stroke="{color}" stroke-width="2" stroke-dasharray="7 5""#));
    let versine = found.iter().filter_map(|errors| Some((errors.half_degrees, errors.versine_form?)));
    let versine: Vec<_> = versine.collect();
    line(out, &versine, &format!(r#"stroke="{color}" stroke-width="3""#));
    let bound = |degrees: f64| (degrees, beams::versine_bound::<S>(degrees));
    let bounds: Vec<_> = versine.iter().map(|&(degrees, _)| bound(degrees)).collect();
    line(out, &bounds, &format!(r#"stroke="{color}" stroke-width="1""#));

    let named = |points: &[(f64, f64)], degrees: f64| {
        points.iter().copied().find(|&(at, _)| at >= degrees).expect("a half angle of the picture")
    };
    let (degrees, error) = named(&cosine, pen.cosine_named);
    let words = format!("{}, 1 − l·s", pen.name);
    text(out, (x(degrees) + 8.0, y(error) - 4.0), &format!(r#"fill="{color}""#), &words);
    let (degrees, error) = named(&versine, pen.versine_named);
    let words = format!("{}, |l − s|² / 2", pen.name);
    let bold = format!(r#"fill="{color}" font-weight="bold" text-anchor="end""#);
    text(out, (x(degrees) - 6.0, y(error) + 16.0), &bold, &words);

    let at = (x(narrowest), y(HALF_A_STEP));
    let _ = writeln!(
        out,
        r#"<circle cx="{:.1}" cy="{:.1}" r="5" fill="white" stroke="{color}" stroke-width="2.5"/>"#,
        at.0, at.1
    );
    let centred = format!(r#"fill="{color}" text-anchor="middle""#);
    // Two digits of the number.
    let decimals = (1 - narrowest.log10().floor() as i32).cast_unsigned() as usize;
    let degrees = format!("{narrowest:.decimals$}");
    text(out, (at.0, at.1 - 12.0), &centred, &format!("{} from {degrees}°", pen.name));
}

/// The picture.
fn svg() -> String {
    let mut out = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13">
<title>Largest error of a soft spotlight over its half angle, by the cosine form and by the versine form</title>
<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>
"#
    );
    text(
        &mut out,
        (LEFT, 24.0),
        r#"font-size="16" font-weight="bold""#,
        "What a narrow beam costs, soft edge",
    );
    let legend = "dashed: the cosine form 1 − l·s; thick: the kernel, |l − s|² / 2, from the narrowest beam (ring) that \
                  the format takes; thin: its bound";
    text(&mut out, (LEFT, 46.0), r##"fill="#555" font-size="12""##, legend);
    axes(&mut out);
    let fx16 = Pen { name: "Fx16", color: "#d55e00", cosine_named: 6.0, versine_named: 60.0 };
    let float = Pen { name: "f32", color: "#0072b2", cosine_named: 0.12, versine_named: 0.1 };
    let fx32 = Pen { name: "Fx32", color: "#009e73", cosine_named: 0.02, versine_named: 0.003 };
    format::<Fx16>(&mut out, &fx16);
    format::<f32>(&mut out, &float);
    format::<Fx32>(&mut out, &fx32);
    out.push_str("</svg>\n");
    out
}

fn main() {
    print!("{}", svg());
}
