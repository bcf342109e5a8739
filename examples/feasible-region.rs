//! Draws `docs/feasible-region.svg`: the ratios of field versine to beam versine that a monotone
//! cubic reaches, for each edge slope.
//!
//! `cargo run -p suite --example feasible-region > docs/feasible-region.svg`. Everything is
//! computed in f64, by search. `tests/suite/two_angles.rs` checks that the picture is up to date.

use std::fmt::Write;
use support::cubics;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 460.0;
const MARGIN: f64 = 60.0;
const MOST_SLOPE: f64 = 4.0;
const RATIOS: (f64, f64) = (1.0, 5.6);

fn x(slope: f64) -> f64 {
    MARGIN + slope / MOST_SLOPE * (WIDTH - 1.5 * MARGIN)
}

fn y(ratio: f64) -> f64 {
    HEIGHT - MARGIN - (ratio - RATIOS.0) / (RATIOS.1 - RATIOS.0) * (HEIGHT - 1.5 * MARGIN)
}

fn path(points: impl Iterator<Item = (f64, f64)>) -> String {
    points.fold(String::new(), |mut path, (slope, ratio)| {
        let _ = write!(path, "{}{:.1},{:.1}", if path.is_empty() { "M" } else { " L" }, x(slope), y(ratio));
        path
    })
}

fn text(out: &mut String, at: (f64, f64), anchor: &str, words: &str) {
    let (x, y) = at;
    let _ = writeln!(out, r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}">{words}</text>"#);
}

fn dot(out: &mut String, at: (f64, f64), dx: f64, words: &str) {
    let (x, y) = (x(at.0), y(at.1));
    let _ = writeln!(out, r##"<circle cx="{x:.1}" cy="{y:.1}" r="4" fill="#b3261e"/>"##);
    text(out, (x + dx, y - 8.0), if dx < 0.0 { "end" } else { "start" }, words);
}

/// The picture.
pub(crate) fn svg() -> String {
    let ranges: Vec<_> = (0..=100)
        .filter_map(|i| Some((f64::from(i) / 25.0, cubics::ratios(f64::from(i) / 25.0, 2_000)?)))
        .collect();
    let lower = ranges.iter().map(|&(slope, (least, _))| (slope, least));
    let upper = ranges.iter().rev().map(|&(slope, (_, most))| (slope, most));
    let quadratics = (0..=40).map(|i| {
        let slope = f64::from(i) / 20.0;
        // A quadratic is the cubic whose slopes add up to 2.
        (slope, cubics::Cubic::with_slopes(slope, 2.0 - slope).ratio())
    });
    let mut out = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13">
<title>Which ratio of field to beam versine each edge slope of a monotone cubic reaches</title>
<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>
"#
    );
    for ratio in 1..=5 {
        let y = y(f64::from(ratio));
        let _ = writeln!(
            out,
            r##"<line x1="{:.1}" y1="{y:.1}" x2="{:.1}" y2="{y:.1}" stroke="#ddd"/>"##,
            x(0.0),
            x(MOST_SLOPE)
        );
        text(&mut out, (x(0.0) - 8.0, y + 4.0), "end", &ratio.to_string());
    }
    for slope in 0..=4 {
        text(&mut out, (x(f64::from(slope)), y(RATIOS.0) + 18.0), "middle", &slope.to_string());
    }
    let region = path(lower.chain(upper));
    let _ = writeln!(out, r##"<path d="{region} Z" fill="#cfe3f7" stroke="#20639b" stroke-width="1.5"/>"##);
    let _ = writeln!(
        out,
        r##"<path d="{}" fill="none" stroke="#1b7f4d" stroke-width="2.5"/>"##,
        path(quadratics)
    );
    dot(&mut out, (0.0, 2.3346), 8.0, "soft");
    dot(&mut out, (2.0, 1.3416), 8.0, "hard");
    dot(&mut out, (1.0, 1.8), 8.0, "linear");
    dot(&mut out, (1.34, 4.587), 8.0, "field 15°, beam 7°");
    text(&mut out, (x(MOST_SLOPE / 2.0), HEIGHT - 14.0), "middle", "slope at the edge, over t");
    text(&mut out, (x(0.0), y(RATIOS.1) + 2.0), "start", "field versine / beam versine");
    text(&mut out, (x(2.9), y(3.6)), "start", "blue: monotone cubics");
    text(&mut out, (x(2.9), y(3.6) + 18.0), "start", "green: quadratics");
    out.push_str("</svg>\n");
    out
}

fn main() {
    print!("{}", svg());
}
