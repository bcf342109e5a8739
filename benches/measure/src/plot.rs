//! The picture of prices: error against instructions on a Cortex-M0, falloffs on the left and lit points on
//! the right.

use crate::record::Record;

/// The file, below the project's folder.
pub(crate) const FILE: &str = "docs/accuracy-vs-cost-cortex-m0.svg";

const BOARD: &str = "cortex-m0";
/// The error, in codes, from which on a display shows a difference.
const VISIBLE: f64 = 0.5;

/// The kernels of the left panel and of the right one, with their labels.
const PANELS: [(&str, &[(&str, &str)]); 2] = [
    (
        "From the angle off axis to an intensity",
        &[
            ("soft.fx16", "soft fx16"),
            ("soft.fx32", "soft fx32"),
            ("soft.f32", "soft f32"),
            ("powf-libm.rival", "powf libm"),
            ("table-256.rival", "table 256"),
            ("gltf.rival", "gltf"),
        ],
    ),
    (
        "The lit point, without and with the inverse square (1/d²)",
        &[
            ("lit.fx16-quick", "fx16-quick"),
            ("lit.fx16", "fx16"),
            ("lit.fx32", "fx32"),
            ("lit.f32", "f32"),
            ("lit-inverse-square.fx16-quick", "1/d²"),
            ("lit-inverse-square.fx16", "1/d²"),
            ("lit-inverse-square.fx32", "1/d²"),
            ("lit-inverse-square.f32", "1/d²"),
            ("lit-q15-difference.rival", "by hand, 15 bits"),
            ("lit-q16-libfixmath.rival", "libfixmath"),
            ("lit-f32-difference.rival", "f32 by hand"),
            ("lit-baked.rival", "baked"),
        ],
    ),
];

/// The colours of the formats, which colour-blind readers can distinguish: M. Okabe and K. Ito, *Color
/// Universal Design*, 2008.
const COLOURS: [(&str, &str); 4] =
    [("fx16", "#d55e00"), ("fx32", "#0072b2"), ("f32", "#009e73"), ("rival", "#000")];

/// The ends of the axes, in powers of ten: instructions by panel, and errors.
const COSTS: [[f64; 2]; 2] = [[1.0, 4.5], [1.5, 4.0]];
const ERRORS: [f64; 2] = [-7.0, 3.0];

/// Left, top, width and height of a panel's frame, in pixels.
const FRAME: [f64; 4] = [70.0, 90.0, 410.0, 400.0];

/// Draws the picture, as SVG.
pub(crate) fn draw(record: &Record) -> String {
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1000 550\" font-family=\"system-ui, sans-serif\" \
         font-size=\"12\">\n<rect width=\"1000\" height=\"550\" fill=\"#fff\"/>\n\
         <text x=\"24\" y=\"32\" font-size=\"18\" font-weight=\"bold\">What accuracy costs: Cortex-M0</text>\n",
    );
    for (number, (title, kernels)) in PANELS.iter().enumerate() {
        svg += &panel(record, title, kernels, FRAME[0] + 490.0 * number as f64, COSTS[number]);
    }
    svg + "</svg>\n"
}

fn panel(record: &Record, title: &str, kernels: &[(&str, &str)], left: f64, costs: [f64; 2]) -> String {
    let [_, top, width, height] = FRAME;
    let x = |power: f64| left + width * (power - costs[0]) / (costs[1] - costs[0]);
    let y = |power: f64| top + height * (ERRORS[1] - power) / (ERRORS[1] - ERRORS[0]);
    let (bottom, right) = (top + height, left + width);
    let mut svg = format!(
        "<text x=\"{left}\" y=\"{}\" font-size=\"14\" font-weight=\"bold\">{title}</text>\n",
        top - 18.0
    );
    let mut line = |from: [f64; 2], to: [f64; 2], style: &str| {
        let [[x1, y1], [x2, y2]] = [from, to];
        svg += &format!("<path d=\"M{x1:.0} {y1:.0}L{x2:.0} {y2:.0}\" {style}/>\n");
    };
    let grid = "stroke=\"#e4e4e4\"";
    let powers = |ends: [f64; 2]| (ends[0].ceil() as i32..=ends[1].floor() as i32).map(f64::from);
    powers(costs).for_each(|power| line([x(power), top], [x(power), bottom], grid));
    powers(ERRORS).for_each(|power| line([left, y(power)], [right, y(power)], grid));
    let visible = y(VISIBLE.log10());
    line([left, visible], [right, visible], "stroke=\"#888\" stroke-dasharray=\"6 4\"");
    let mut text = |x: f64, y: f64, anchor: &str, words: &str| {
        svg += &format!("<text x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"{anchor}\">{words}</text>\n");
    };
    powers(costs).for_each(|power| text(x(power), bottom + 18.0, "middle", &10_f64.powf(power).to_string()));
    powers(ERRORS).for_each(|power| text(left - 8.0, y(power) + 4.0, "end", &format!("1e{power}")));
    text((left + right) / 2.0, bottom + 40.0, "middle", "instructions a call");
    text(right - 4.0, visible - 5.0, "end", "half a code is visible");
    text(left, top - 4.0, "start", "largest error, in codes of 8 bits");
    let (group, errors) = (record.group(BOARD), record.group("errors"));
    for (name, label) in kernels {
        let figures = group.number(name, "instructions").zip(errors.number(name, "codes"));
        let Some((x, y)) = figures.map(|(cost, error)| (x(cost.log10()), y(error.max(1e-7).log10()))) else {
            continue;
        };
        let (_, format) = name.split_once('.').unwrap_or_default();
        let standard = format.trim_end_matches("-quick");
        let colour = COLOURS.iter().find(|(of, _)| *of == standard).map_or("#000", |(_, colour)| *colour);
        // The marker of a quick evaluation is hollow.
        let fill = if standard == format { colour } else { "#fff" };
        svg += &format!(
            "<circle cx=\"{x:.0}\" cy=\"{y:.0}\" r=\"5\" fill=\"{fill}\" stroke=\"{colour}\" stroke-width=\"2\"/>\n\
             <text x=\"{:.0}\" y=\"{:.0}\" fill=\"{colour}\">{label}</text>\n",
            x + 9.0,
            y + 4.0
        );
    }
    svg
}
