//! The chips on which the demo prices a light, and what a picture costs on them beside its lit
//! points.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use serde_json::{Value, json};

/// The file in the demo's folder.
const FILE: &str = "chips.json";

/// A processor whose instructions are counted, and a chip with it.
struct Chip {
    name: &'static str,
    title: &'static str,
    part: &'static str,
    /// The clock of the chip: the highest that its data sheet allows.
    megahertz: u32,
}

const CHIPS: [Chip; 4] = [
    Chip { name: "cortex-m0", title: "Cortex-M0+", part: "RP2040", megahertz: 133 },
    Chip { name: "cortex-m3", title: "Cortex-M3", part: "STM32F103", megahertz: 72 },
    Chip { name: "cortex-m4f", title: "Cortex-M4F", part: "STM32F411", megahertz: 100 },
    Chip { name: "rv32imc", title: "RV32IMC", part: "ESP32-C3", megahertz: 160 },
];

/// The evaluations of a light.
const EVALUATIONS: [&str; 5] = ["fx16-quick", "fx16", "fx32", "f32-quick", "f32"];

/// The stage of the recorded picture that depends on the evaluation of the light.
const LIGHT: &str = "light";

/// Writes the list into the demo's folder, from the records in `docs`.
pub(super) fn write(docs: &Path, site: &Path) -> Result<()> {
    let file = site.join(FILE);
    let list = list(&read(docs, "frame.json")?, &read(docs, "accuracy-vs-cost.json")?)?;
    fs::write(&file, list.to_string()).with_context(|| format!("cannot write {}", file.display()))
}

fn read(docs: &Path, name: &str) -> Result<Value> {
    let text = fs::read_to_string(docs.join(name)).with_context(|| format!("cannot read {name}"))?;
    serde_json::from_str(&text).with_context(|| format!("{name} is no JSON"))
}

/// The chips, each with the instructions and cycles of the recorded picture but for its lit points.
/// `reached` is the number of lit points: what a shadow covers is lit before the shadow is known.
fn list(frame: &Value, prices: &Value) -> Result<Value> {
    let pixels = Pixels::parse(frame["light"].as_str().context("the frame has no pixels")?)?;
    let chips = CHIPS.iter().map(|chip| {
        let board = &frame["boards"][chip.name];
        let rest = EVALUATIONS.iter().map(|evaluation| {
            let rest = |unit| pixels.rest(board, prices, chip.name, evaluation, unit);
            Ok((*evaluation, json!({ "instructions": rest("instructions")?, "cycles": rest("cycles")? })))
        });
        Ok(json!({
            "name": chip.name, "title": chip.title, "part": chip.part, "megahertz": chip.megahertz,
            "rest": rest.collect::<Result<BTreeMap<_, _>>>()?,
        }))
    });
    Ok(json!({
        "pixels": frame["pixels"], "reached": pixels.reached, "chips": chips.collect::<Result<Vec<_>>>()?,
    }))
}

/// How many pixels of the recorded picture cost how much light.
struct Pixels {
    facing_away: f64,
    outside: f64,
    reached: f64,
}

impl Pixels {
    fn parse(text: &str) -> Result<Self> {
        let count = |what: &str| {
            let part = text.split(", ").find_map(|part| part.strip_suffix(what)?.trim().parse::<f64>().ok());
            part.with_context(|| format!("the frame does not say how many pixels are {what}"))
        };
        Ok(Self {
            facing_away: count("facing away")?,
            outside: count("outside the cone")?,
            reached: count("in shadow")? + count("lit")?,
        })
    }

    /// Instructions or cycles of the picture on a chip but for its lit points; `None` if they were
    /// not counted.
    fn rest(
        &self,
        board: &Value,
        prices: &Value,
        chip: &str,
        evaluation: &str,
        unit: &str,
    ) -> Result<Option<f64>> {
        let Some(stages) = board[unit].as_object() else { return Ok(None) };
        let others = stages.iter().filter(|(stage, _)| *stage != LIGHT);
        let others: f64 = others.filter_map(|(_, count)| count.as_f64()).sum();
        let away = price(prices, "away", evaluation, chip, unit)?;
        let outside = price(prices, "outside", evaluation, chip, unit)?;
        Ok(Some((others + self.facing_away * away + self.outside * outside).round()))
    }
}

fn price(prices: &Value, kernel: &str, evaluation: &str, chip: &str, unit: &str) -> Result<f64> {
    let mut rows = prices["rows"].as_array().into_iter().flatten();
    let row =
        rows.find(|row| row["kernel"] == kernel && row["format"] == evaluation && row["stage"] == "lit");
    row.and_then(|row| row["cost"][chip][unit].as_f64())
        .with_context(|| format!("the price list has no {unit} of {kernel} in {evaluation} on the {chip}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::project;

    /// The recorded picture has the light by the quick evaluation of 16 bits, which is estimated
    /// here as for every other evaluation.
    #[test]
    fn the_estimate_of_a_picture_is_near_the_recorded_one() {
        let docs = project::root().join("docs");
        let [frame, prices] = ["frame.json", "accuracy-vs-cost.json"].map(|name| read(&docs, name).unwrap());
        let list = list(&frame, &prices).unwrap();
        let number = |value: &Value| value.as_f64().unwrap();
        for chip in list["chips"].as_array().unwrap() {
            let name = chip["name"].as_str().unwrap();
            for unit in ["instructions", "cycles"] {
                let Some(stages) = frame["boards"][name][unit].as_object() else { continue };
                let counted: f64 = stages.values().map(number).sum();
                let point = price(&prices, "lit-inverse-square", "fx16-quick", name, unit).unwrap();
                let estimated = number(&chip["rest"]["fx16-quick"][unit]) + number(&list["reached"]) * point;
                let error = estimated / counted - 1.0;
                assert!(error.abs() < 0.1, "{name}: {estimated} {unit}, {counted} were counted");
            }
        }
    }
}
