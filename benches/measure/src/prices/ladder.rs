//! The evaluations of a lit point, the cheapest first: which is good enough for which display.

use serde::{Deserialize, Serialize};

use super::figures;
use super::list::PriceList;
use crate::record::{Figure, Group};

/// The errors of an evaluation in a cone.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Rung {
    pub(crate) kernel: String,
    pub(crate) stage: String,
    pub(crate) format: String,
    /// The falloff.
    pub(crate) edge: String,
    /// The outer half angle in degrees.
    pub(crate) half_angle: f64,
    /// The largest errors; none if the evaluation does not support the cone.
    pub(crate) errors: Option<Steps>,
}

/// The largest errors, in linear codes and in steps of displays.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Steps {
    pub(crate) codes: f64,
    pub(crate) rgb565: f64,
    pub(crate) rgb888: f64,
}

const INTRODUCTION: &str = "
## Which evaluation for which display

A lit point by each evaluation: the narrowest of seven half angles (1°, 3°, 5°, 15°, 22°, 45°, 80°) from which on it errs at
most one step of a display at every brightness, and its instructions. The display encodes in sRGB; a step is 1/63 (the
green channel of RGB565) or 1/255 (RGB888) after encoding, before the rounding to steps. sRGB magnifies the errors of
dark light 13 times, so a hard edge, which is steep where it is dark, needs more than a soft one. *Attenuated* means by
the inverse square from 16 times full scale at a distance of 1, at distances from 1 to 7; the light is clipped at full scale.
Errors are searched: the largest of 65,536 points, at incidences up to 80°. At grazing incidence close to a bright light they are
larger: `luminaire pick` searches there, too. Instructions are those of a soft edge with a half angle of 21.8°; in a narrow cone or
under a bright light, more points of `fx16` take its fine evaluation.
";

/// The boards whose instructions are shown, with their titles.
const BOARDS: [(&str, &str); 3] =
    [("cortex-m0", "Cortex-M0"), ("rv32imc", "RV32IMC"), ("cortex-m4f", "Cortex-M4F")];
const KERNELS: [(&str, &str); 2] = [("lit", ""), ("lit-inverse-square", ", attenuated")];
const EDGES: [&str; 2] = ["soft", "hard"];

type Step = fn(&Steps) -> f64;
const DISPLAYS: [(&str, Step); 2] = [("RGB565", |errors| errors.rgb565), ("RGB888", |errors| errors.rgb888)];

/// Adds the errors to a group of figures.
pub(super) fn errors(ladder: &[Rung], group: &mut Group) {
    for rung in ladder {
        let Rung { kernel, format, edge, half_angle, errors, .. } = rung;
        let name = |what: &str| format!("{kernel}.{format}, {edge} of {half_angle} degrees, {what}");
        match errors {
            None => group.add(name("errors"), Figure::Text("refused".to_owned())),
            Some(Steps { codes, rgb565, rgb888 }) => {
                for (what, value) in [("codes", codes), ("steps of RGB565", rgb565), ("of RGB888", rgb888)] {
                    group.add(name(what), Figure::Exact(*value));
                }
            }
        }
    }
}

/// Writes the part of the page.
pub(super) fn write(list: &PriceList) -> String {
    let mut text = INTRODUCTION.to_owned();
    let mut formats: Vec<&str> = Vec::new();
    for rung in &list.ladder {
        if !formats.contains(&rung.format.as_str()) {
            formats.push(&rung.format);
        }
    }
    for (kernel, suffix) in KERNELS {
        let heads =
            EDGES.map(|edge| DISPLAYS.map(|(display, _)| format!(" {edge}{suffix}, {display} |")).concat());
        let boards = BOARDS.map(|(_, title)| format!(" {title} |"));
        text += &format!("\n| |{}{}\n|---|{}\n", heads.concat(), boards.concat(), "---|".repeat(7));
        for format in &formats {
            let edges = EDGES.map(|edge| {
                let cones = cones(list, kernel, format, edge);
                DISPLAYS.map(|(_, step)| format!(" {} |", offered(&cones, step))).concat()
            });
            let costs = BOARDS.map(|(board, _)| {
                let cost = list.row(&format!("{kernel}.{format}")).and_then(|row| row.cost.get(board));
                format!(" {} |", cost.map_or_else(String::new, |cost| figures::cost(cost.amount())))
            });
            text += &format!("| `{format}` |{}{}\n", edges.concat(), costs.concat());
        }
    }
    text +=
        "\n<details><summary>The errors, in linear codes and, in brackets, in steps of RGB565</summary>\n";
    for (kernel, suffix) in KERNELS {
        for edge in EDGES {
            let angles = cones(list, kernel, formats.first().unwrap_or(&""), edge);
            let heads: String = angles.iter().map(|rung| format!(" {}° |", rung.half_angle)).collect();
            text += &format!("\n| {edge}{suffix} |{heads}\n|---|{}\n", "---|".repeat(angles.len()));
            for format in &formats {
                let cells = cones(list, kernel, format, edge).into_iter().map(|rung| match rung.errors {
                    None => " refused |".to_owned(),
                    Some(Steps { codes, rgb565, .. }) => {
                        format!(" {} ({}) |", figures::error(codes), figures::error(rgb565))
                    }
                });
                text += &format!("| `{format}` |{}\n", cells.collect::<String>());
            }
        }
    }
    text + "\n</details>\n"
}

/// The rungs of an evaluation, the narrowest cone first.
fn cones<'a>(list: &'a PriceList, kernel: &str, format: &str, edge: &str) -> Vec<&'a Rung> {
    let is_asked = |rung: &&Rung| {
        (rung.kernel.as_str(), rung.format.as_str(), rung.edge.as_str()) == (kernel, format, edge)
    };
    list.ladder.iter().filter(is_asked).collect()
}

/// From which half angle on every cone errs at most one step.
fn offered(cones: &[&Rung], step: Step) -> String {
    let holds = |rung: &&&Rung| rung.errors.as_ref().is_some_and(|errors| step(errors) <= 1.0);
    let narrowest = cones.iter().rev().take_while(holds).last();
    narrowest.map_or_else(|| "no".to_owned(), |rung| format!("from {}°", rung.half_angle))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_evaluation_is_offered_from_the_narrowest_cone_on_that_holds_with_all_wider_ones() {
        let rung = |half_angle: f64, rgb565: f64| Rung {
            kernel: "lit".to_owned(),
            stage: "lit".to_owned(),
            format: "fx16".to_owned(),
            edge: "hard".to_owned(),
            half_angle,
            errors: (rgb565 < 9.0).then_some(Steps { codes: 0.0, rgb565, rgb888: 4.0 * rgb565 }),
        };
        let rungs = [rung(1.0, 9.0), rung(3.0, 0.9), rung(5.0, 1.1), rung(15.0, 1.0), rung(80.0, 0.2)];
        let rungs: Vec<_> = rungs.iter().collect();
        assert_eq!(offered(&rungs, |errors| errors.rgb565), "from 15°");
        assert_eq!(offered(&rungs, |errors| errors.rgb888), "from 80°");
        assert_eq!(offered(&rungs[..1], |errors| errors.rgb565), "no");
    }
}
