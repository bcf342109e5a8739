//! The picture of a target: error against cost, falloffs on the left and lit points on the right.

mod axis;
mod labels;
mod marker;

use self::axis::{Axis, power_of_ten};
use self::labels::{Labels, Rectangle};
use super::frontier::frontier;
use super::list::{PriceList, Row};
use super::target::Target;

const WIDTH: f64 = 1000.0;
const HEIGHT: f64 = 560.0;
/// The panels' tops and bottoms, and the left and right of each.
const TOP: f64 = 96.0;
const BOTTOM: f64 = 500.0;
const SIDES: [(f64, f64); 2] = [(72.0, 520.0), (580.0, 984.0)];
/// What a display tells from the truth: half a code.
const VISIBLE: f64 = 0.5;

/// A kernel in the picture.
#[derive(Clone, Debug)]
struct Mark {
    cost: f64,
    error: f64,
    format: String,
    /// Whether it does what the frontier is drawn of: a soft edge, without distance or highlight.
    is_subject: bool,
    /// Text beside the point, and `title`, the text of its tooltip.
    label: Option<String>,
    title: String,
}

/// Draws the picture of a target.
pub(crate) fn draw(list: &PriceList, target: &Target) -> String {
    let panels = ["falloff", "lit"].map(|stage| marks(list, target, stage));
    let errors = panels.iter().flatten().map(|mark| mark.error);
    let vertical = Axis::decades(errors.chain([VISIBLE]), (BOTTOM, TOP));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"system-ui, \
         -apple-system, Segoe UI, Helvetica, Arial, sans-serif\" font-size=\"13\" fill=\"#222\">\n\
         <title>What accuracy costs: {}</title>\n<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#fff\"/>\n",
        target.title()
    );
    svg += &text(24.0, 28.0, "start", 18, "bold", &format!("What accuracy costs: {}", target.title()));
    svg += &legend();
    svg += &format!(
        "<text transform=\"translate(20 {}) rotate(-90)\" text-anchor=\"middle\">largest error, in codes of 8 bits</text>\n",
        (TOP + BOTTOM) / 2.0
    );
    for ((marks, sides), name) in panels
        .iter()
        .zip(SIDES)
        .zip(["From the angle off axis to an intensity", "The lit point, rejects not taken"])
    {
        svg += &panel(marks, sides, &vertical, name, target);
    }
    svg + "</svg>\n"
}

/// The kernels of a stage that have an error and a cost. The loop that does nothing is none, and
/// what is rejected errs not.
fn marks(list: &PriceList, target: &Target, stage: &str) -> Vec<Mark> {
    let rows = list.rows.iter().filter(|row| row.stage == stage && row.kernel != "clamp");
    rows.filter_map(|row| {
        let error = row.error.as_ref().map(|error| error.codes).filter(|codes| *codes > 0.0)?;
        let cost = row.cost.get(target.name())?.amount();
        let title = format!("{}: {cost} {}, off by {error:.1e} codes", row.name(), target.unit());
        let is_subject = row.format == "rival" || matches!(row.kernel.as_str(), "soft" | "lit");
        Some(Mark { cost, error, format: row.format.clone(), is_subject, label: label(row), title })
    })
    .collect()
}

/// Of the profiles one stands for all of its format: they lie close together.
fn label(row: &Row) -> Option<String> {
    let label = match (row.stage.as_str(), row.kernel.as_str()) {
        (_, kernel) if row.format == "rival" => kernel.replace('-', " "),
        ("falloff", "soft") => format!("soft {}", row.format),
        ("lit", "lit") => row.format.clone(),
        ("lit", "lit-inverse-square") => "+ 1/d²".to_owned(),
        ("lit", "lit-specular") => "+ Phong".to_owned(),
        _ => return None,
    };
    Some(label)
}

fn panel(marks: &[Mark], sides: (f64, f64), vertical: &Axis, name: &str, target: &Target) -> String {
    let (left, right) = sides;
    let horizontal = Axis::steps(marks.iter().map(|mark| mark.cost), sides);
    let mut svg = text(left, TOP - 14.0, "start", 14, "bold", name);
    for (tick, value) in vertical.ticks() {
        svg += &line((left, tick), (right, tick), "#e4e4e4", "");
        if power_of_ten(value) % 2 == 0 {
            svg += &text(left - 8.0, tick + 4.0, "end", 12, "normal", &ten_to(power_of_ten(value)));
        }
    }
    for (tick, value) in horizontal.ticks() {
        svg += &line((tick, TOP), (tick, BOTTOM), "#e4e4e4", "");
        svg += &text(tick, BOTTOM + 18.0, "middle", 12, "normal", &value.to_string());
    }
    let visible = vertical.place(VISIBLE);
    svg += &line((left, visible), (right, visible), "#888", " stroke-dasharray=\"6 4\"");
    svg += &format!(
        "<rect x=\"{left}\" y=\"{TOP}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#666\"/>\n",
        right - left,
        BOTTOM - TOP
    );
    let unit = match target {
        Target::Board(_) => "instructions a call",
        _ => "nanoseconds a call",
    };
    svg += &text((left + right) / 2.0, BOTTOM + 40.0, "middle", 13, "normal", unit);
    let places: Vec<_> =
        marks.iter().map(|mark| (horizontal.place(mark.cost), vertical.place(mark.error))).collect();
    let corners = corners(marks, &places);
    svg += &stairs(&corners);
    let frame = Rectangle { left, top: TOP, right, bottom: BOTTOM };
    let mut labels = Labels::new(frame, &places);
    for pair in corners.windows(2) {
        labels.avoid(pair[0], pair[1]);
    }
    svg += &labels.place("half a code", (right - 34.0, visible), 11);
    // What is compared stands in front, and larger.
    for is_subject in [false, true] {
        let (radius, opacity) = if is_subject { (6.0, 1.0) } else { (4.0, 0.5) };
        for (mark, place) in marks.iter().zip(&places).filter(|(mark, _)| mark.is_subject == is_subject) {
            let marker = marker::draw(&mark.format, *place, radius);
            svg += &format!("<g opacity=\"{opacity}\"><title>{}</title>{marker}</g>\n", mark.title);
        }
    }
    for (mark, place) in marks.iter().zip(&places) {
        if let Some(label) = &mark.label {
            svg += &labels.place(label, *place, 12);
        }
    }
    svg
}

/// The corners of the frontier of soft edges and rivals, as stairs: whoever pays more gets nothing
/// better until the next step.
fn corners(marks: &[Mark], places: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let subjects: Vec<_> = marks.iter().zip(places).filter(|(mark, _)| mark.is_subject).collect();
    let points: Vec<_> = subjects.iter().map(|(mark, _)| (mark.cost, mark.error)).collect();
    let mut corners: Vec<(f64, f64)> = Vec::new();
    for index in frontier(&points) {
        let (x, y) = *subjects[index].1;
        if let Some(&(_, above)) = corners.last() {
            corners.push((x, above));
        }
        corners.push((x, y));
    }
    corners
}

fn stairs(corners: &[(f64, f64)]) -> String {
    let points: Vec<_> = corners.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
    format!(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"#b8b8b8\" stroke-width=\"6\" stroke-linejoin=\"round\" \
         stroke-linecap=\"round\"/>\n",
        points.join(" ")
    )
}

fn legend() -> String {
    let mut svg = String::new();
    let mut left = 24.0;
    for (format, _) in marker::ALL {
        svg += &marker::draw(format, (left + 6.0, 50.0), 5.5);
        svg += &text(left + 18.0, 54.0, "start", 13, "normal", format);
        left += 42.0 + 7.6 * format.len() as f64;
    }
    svg += &format!(
        "<path d=\"M{left} 50h30\" stroke=\"#b8b8b8\" stroke-width=\"6\" stroke-linecap=\"round\"/>\n"
    );
    svg + &text(
        left + 40.0,
        54.0,
        "start",
        13,
        "normal",
        "the best soft edge for its price (left, down: better)",
    )
}

fn text(x: f64, y: f64, anchor: &str, size: u32, weight: &str, words: &str) -> String {
    format!(
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" font-size=\"{size}\" font-weight=\"{weight}\">{words}</text>\n"
    )
}

fn line(from: (f64, f64), to: (f64, f64), colour: &str, more: &str) -> String {
    format!(
        "<line x1=\"{:.1}\" y1=\"{:.1}\" x2=\"{:.1}\" y2=\"{:.1}\" stroke=\"{colour}\"{more}/>\n",
        from.0, from.1, to.0, to.1
    )
}

/// A power of ten as it is printed.
fn ten_to(power: i32) -> String {
    match power {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        2 => "100".to_owned(),
        _ => {
            let exponent = power.to_string().replace('-', "\u{2212}");
            format!("10<tspan dy=\"-5\" font-size=\"9\">{exponent}</tspan>")
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::list::{Cost, Error};
    use super::*;

    #[test]
    fn a_kernel_with_an_error_and_a_cost_is_in_the_picture() {
        let row = |kernel: &str, codes: f64| Row {
            kernel: kernel.to_owned(),
            stage: "falloff".to_owned(),
            format: "fx16".to_owned(),
            error: Some(Error {
                codes,
                lsb: 1.0,
                at: None,
                mean_codes: 0.0,
                p999_codes: 0.0,
                kind: "searched".to_owned(),
            }),
            narrower: Vec::new(),
            cost: BTreeMap::from([(
                "host".to_owned(),
                Cost::Timed { ns: 1.5, ns_quartiles: [1.0, 2.0], ratio_to_powf: 3.0 },
            )]),
            bytes: BTreeMap::new(),
        };
        let list = PriceList { rows: vec![row("soft", 0.02), row("step", 0.0)], ..PriceList::default() };
        let svg = draw(&list, &Target::Host);
        assert!(svg.contains("soft.fx16: 1.5 ns") && !svg.contains("step.fx16"), "{svg}");
        assert_eq!(ten_to(-4), "10<tspan dy=\"-5\" font-size=\"9\">\u{2212}4</tspan>");
    }
}
