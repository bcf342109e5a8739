//! Draws `docs/narrow-beams.svg`: the largest error of a soft spotlight over its half angle. It
//! shows the cosine form, and the versine form in each format with the narrowest beam that the
//! format supports.
//!
//! `cargo run --release --example narrow-beams > docs/narrow-beams.svg`. All errors are measured
//! against the tests' f64 reference. `tests/slow/limits.rs` checks the bounds of the lines.

#[path = "figures/gallery/svg.rs"]
mod svg;

use luminaire::{Fx16, Fx32};
use support::{
    beams::{self, Errors},
    format::Format,
};
use svg::{Drawing, Frame, Place};

/// The picture, by powers of ten: half angles in degrees, and errors.
const FRAME: Frame = Frame { x: [(84.0, -5.0), (836.0, 2.0)], y: [(538.0, -9.0), (64.0, 0.0)] };

const HALF_A_STEP: f64 = 1.0 / 510.0;

const GRID: &str = r##"stroke="#e4e4e4""##;
const GREY: &str = "#555";
const BLACK: &str = "#000";

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

fn place((degrees, error): (f64, f64)) -> Place {
    FRAME.place(degrees.log10(), error.log10())
}

fn line(drawing: &mut Drawing, points: &[(f64, f64)], color: &str, style: &str) {
    drawing.path(points.iter().copied().map(place), &format!(r#"fill="none" stroke="{color}" {style}"#));
}

/// A power of ten as a label, with its unit.
fn power(exponent: i32, unit: &str) -> String {
    match exponent {
        -3.. => format!("{}{unit}", 10.0_f64.powi(exponent)),
        _ => format!(r#"10<tspan dy="-5" font-size="10">{exponent}</tspan><tspan dy="5">{unit}</tspan>"#),
    }
}

fn axes(drawing: &mut Drawing) {
    for exponent in -5..=2 {
        let [foot, top] = [-9.0, 0.0].map(|error| FRAME.place(exponent.into(), error));
        drawing.line(foot, top, GRID);
        drawing.text((foot.0, foot.1 + 20.0), "middle", BLACK, &power(exponent, "°"));
    }
    for exponent in -9..=0 {
        let (from, to) = FRAME.level(exponent.into());
        drawing.line(from, to, GRID);
        drawing.text((from.0 - 8.0, from.1 + 4.0), "end", BLACK, &power(exponent, ""));
    }
    drawing.text((460.0, 586.0), "middle", BLACK, "half angle of the cone");
    let (from, to) = FRAME.level(HALF_A_STEP.log10());
    drawing.line(from, to, r##"stroke="#555" stroke-width="1.5""##);
    drawing.text((place((2.2, HALF_A_STEP)).0, from.1 - 8.0), "start", GREY, "half an 8-bit step");
}

/// The measured lines of one format, the bound of the kernel's, and its narrowest beam.
fn format<S: Format>(drawing: &mut Drawing, pen: &Pen) {
    let narrowest = beams::narrowest::<S>();
    let (from, to) = (1e-5, 89.0_f64);
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
    line(drawing, &cosine[begin..], color, r#"stroke-width="2" stroke-dasharray="7 5""#);
    let versine = found.iter().filter_map(|errors| Some((errors.half_degrees, errors.versine_form?)));
    let versine: Vec<_> = versine.collect();
    line(drawing, &versine, color, r#"stroke-width="3""#);
    let bound = |&(degrees, _): &(f64, f64)| (degrees, beams::versine_bound::<S>(degrees));
    let bounds: Vec<_> = versine.iter().map(bound).collect();
    line(drawing, &bounds, color, r#"stroke-width="1""#);

    let named = |points: &[(f64, f64)], degrees: f64| {
        place(points.iter().copied().find(|&(at, _)| at >= degrees).expect("a half angle of the picture"))
    };
    let (x, y) = named(&cosine, pen.cosine_named);
    drawing.text((x + 8.0, y - 4.0), "start", color, &format!("{}, 1 − l·s", pen.name));
    let (x, y) = named(&versine, pen.versine_named);
    drawing.text((x - 6.0, y + 16.0), "end", color, &format!("{}, |l − s|² / 2", pen.name));

    let (x, y) = place((narrowest, HALF_A_STEP));
    drawing.dot((x, y), color);
    // Two digits of the number.
    let decimals = (1 - narrowest.log10().floor() as i32).cast_unsigned() as usize;
    let words = format!("{} from {narrowest:.decimals$}°", pen.name);
    drawing.text((x, y - 12.0), "middle", color, &words);
}

fn main() {
    let title = "Largest error of the intensity of a soft spotlight over its half angle, full scale is 1";
    let mut drawing = Drawing::new(860.0, 600.0, title);
    drawing.text((84.0, 24.0), "start", BLACK, title);
    let legend = "dashed: the cosine form 1 − l·s; thick: the kernel, from the narrowest beam (dot) on; thin: its bound";
    drawing.text((84.0, 46.0), "start", GREY, legend);
    axes(&mut drawing);
    let fx16 = Pen { name: "Fx16", color: "#d55e00", cosine_named: 6.0, versine_named: 60.0 };
    let float = Pen { name: "f32", color: "#0072b2", cosine_named: 0.12, versine_named: 0.1 };
    let fx32 = Pen { name: "Fx32", color: "#009e73", cosine_named: 0.02, versine_named: 0.003 };
    format::<Fx16>(&mut drawing, &fx16);
    format::<f32>(&mut drawing, &float);
    format::<Fx32>(&mut drawing, &fx32);
    print!("{}", drawing.finish());
}
