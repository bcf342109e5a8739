//! The picture of a target: error against cost, falloffs on the left and lit points on the right.

mod labels;
mod marker;

use std::error::Error;
use std::ops::Range;

use anyhow::{Result, anyhow};
use plotters::coord::Shift;
use plotters::prelude::*;

use self::labels::Labels;
use super::frontier::frontier;
use super::list::{PriceList, Row};
use super::target::Target;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// A position in pixels.
type Pixel = (i32, i32);

const SIZE: (u32, u32) = (1000, 560);
const FONT: &str = "system-ui, sans-serif";
const STAIRS: RGBColor = RGBColor(184, 184, 184);
const GRID: RGBColor = RGBColor(228, 228, 228);
/// The error, in codes, from which on a display shows a difference.
const VISIBLE: f64 = 0.5;
/// The stages, with the titles of their panels.
const PANELS: [(&str, &str); 2] =
    [("falloff", "From the angle off axis to an intensity"), ("lit", "The lit point, no early-out taken")];

/// A kernel in the picture.
#[derive(Clone, Debug)]
struct Mark {
    cost: f64,
    error: f64,
    format: String,
    /// Whether the kernel counts for the frontier: a soft edge without distance and highlight, or a
    /// rival.
    is_subject: bool,
    /// Text beside the point.
    label: Option<String>,
}

/// Draws the picture of a target, as SVG.
pub(super) fn draw(list: &PriceList, target: &Target) -> Result<String> {
    let mut svg = String::new();
    picture(&mut svg, list, target).map_err(|error| anyhow!("cannot draw {}: {error}", target.picture()))?;
    Ok(svg)
}

fn picture(svg: &mut String, list: &PriceList, target: &Target) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let title = (FONT, 18).into_font().style(FontStyle::Bold);
    root.draw_text(&format!("What accuracy costs: {}", target.title()), &title.into(), (24, 12))?;
    legend(&root)?;
    let panels = PANELS.map(|(stage, title)| (marks(list, target, stage), title));
    let errors = panels.iter().flat_map(|(marks, _)| marks).map(|mark| mark.error).chain([VISIBLE]);
    let (least, most) = ends(errors);
    let errors = 10_f64.powf(least.log10().floor())..10_f64.powf(most.log10().ceil());
    let areas = root.margin(66, 6, 24, 12).split_evenly((1, 2));
    for ((marks, title), area) in panels.iter().zip(&areas) {
        panel(&root, area, marks, title, errors.clone(), target)?;
    }
    root.present()?;
    Ok(())
}

/// The kernels of a stage that have an error above 0 and a cost, except `clamp`, which does almost
/// no work.
fn marks(list: &PriceList, target: &Target, stage: &str) -> Vec<Mark> {
    let rows = list.rows.iter().filter(|row| row.stage == stage && row.kernel != "clamp");
    rows.filter_map(|row| {
        let error = row.error.as_ref().map(|error| error.codes).filter(|codes| *codes > 0.0)?;
        let cost = row.cost.get(target.name())?.amount();
        let is_subject = row.format == "rival" || matches!(row.kernel.as_str(), "soft" | "lit");
        Some(Mark { cost, error, format: row.format.clone(), is_subject, label: label(row) })
    })
    .collect()
}

/// The label of a row, if it has one. The profiles of a format lie close together, so that only the
/// soft one is labelled.
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

fn panel(
    root: &Area<'_>,
    area: &Area<'_>,
    marks: &[Mark],
    title: &str,
    errors: Range<f64>,
    target: &Target,
) -> Result<(), Box<dyn Error>> {
    let (least, most) = ends(marks.iter().map(|mark| mark.cost));
    let mut chart = ChartBuilder::on(area)
        .caption(title, (FONT, 14).into_font().style(FontStyle::Bold))
        .x_label_area_size(44)
        .y_label_area_size(62)
        .build_cartesian_2d((least / 1.25..most * 1.5).log_scale(), errors.clone().log_scale())?;
    chart
        .configure_mesh()
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .label_style((FONT, 12))
        .axis_desc_style((FONT, 13))
        .x_desc(format!("{} a call", target.unit()))
        .y_desc("largest error, in codes of 8 bits")
        .x_label_formatter(&|value| format!("{value}"))
        .y_label_formatter(&|value| power_of_ten(*value))
        .draw()?;
    let visible = [(least / 1.25, VISIBLE), (most * 1.5, VISIBLE)];
    chart.draw_series(DashedLineSeries::new(visible, 6, 4, RGBColor(136, 136, 136).into()))?;
    let corners = corners(marks);
    chart.draw_series(LineSeries::new(corners.iter().copied(), STAIRS.stroke_width(6)))?;
    let at = |cost: f64, error: f64| chart.backend_coord(&(cost, error));
    let places: Vec<_> = marks.iter().map(|mark| at(mark.cost, mark.error)).collect();
    let (left, top) = at(least / 1.25, errors.end);
    let (right, bottom) = at(most * 1.5, errors.start);
    let mut labels = Labels::new([left, top, right, bottom], &places);
    for pair in corners.windows(2) {
        labels.avoid(at(pair[0].0, pair[0].1), at(pair[1].0, pair[1].1));
    }
    labels.place(root, "half a code", (right - 34, at(most, VISIBLE).1), 11)?;
    // The compared kernels are drawn last and larger, in front of the others.
    for is_subject in [false, true] {
        for (mark, place) in marks.iter().zip(&places).filter(|(mark, _)| mark.is_subject == is_subject) {
            marker::draw(root, &mark.format, *place, is_subject)?;
        }
    }
    for (mark, place) in marks.iter().zip(&places) {
        if let Some(label) = &mark.label {
            labels.place(root, label, *place, 12)?;
        }
    }
    Ok(())
}

/// The corners of the frontier of soft edges and rivals, drawn as stairs: between two steps a
/// higher cost buys no accuracy.
fn corners(marks: &[Mark]) -> Vec<(f64, f64)> {
    let subjects = marks.iter().filter(|mark| mark.is_subject);
    let points: Vec<_> = subjects.map(|mark| (mark.cost, mark.error)).collect();
    let mut corners: Vec<(f64, f64)> = Vec::new();
    for index in frontier(&points) {
        let (cost, error) = points[index];
        if let Some(&(_, above)) = corners.last() {
            corners.push((cost, above));
        }
        corners.push((cost, error));
    }
    corners
}

fn legend(root: &Area<'_>) -> Result<(), Box<dyn Error>> {
    let style = (FONT, 13).into_text_style(root);
    let mut left = 24;
    for (format, _) in marker::ALL {
        marker::draw(root, format, (left + 6, 50), true)?;
        root.draw_text(format, &style, (left + 18, 42))?;
        left += 42 + 8 * format.len() as i32;
    }
    root.draw(&PathElement::new([(left, 50), (left + 30, 50)], STAIRS.stroke_width(6)))?;
    root.draw_text("the best soft edge for its price; hollow: quick", &style, (left + 40, 42))?;
    Ok(())
}

/// Minimum and maximum of some values; `(1, 10)` if there are none.
fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let ends =
        values.fold((f64::INFINITY, 0.0_f64), |(least, most), value| (least.min(value), most.max(value)));
    if ends.0 <= ends.1 { ends } else { (1.0, 10.0) }
}

/// Formats a power of ten, as in 10⁻².
fn power_of_ten(value: f64) -> String {
    let digit = |digit: char| match digit {
        '-' => '⁻',
        digit => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit.to_digit(10).unwrap_or_default() as usize).unwrap_or(digit),
    };
    match value.log10().round() as i32 {
        power @ 0..=2 => 10_u32.pow(power as u32).to_string(),
        power => format!("10{}", power.to_string().chars().map(digit).collect::<String>()),
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
            format: "rival".to_owned(),
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
        let list =
            PriceList { rows: vec![row("schlick", 0.02), row("smoothstep", 0.0)], ..PriceList::default() };
        let svg = draw(&list, &Target::Host).unwrap();
        assert!(svg.contains("schlick") && !svg.contains("smoothstep"), "{svg}");
        assert_eq!([1e-4, 1.0, 100.0, 1e12].map(power_of_ten), ["10⁻⁴", "1", "100", "10¹²"]);
    }
}
