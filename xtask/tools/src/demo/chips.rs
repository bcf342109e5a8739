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

const CHIPS: [Chip; 7] = [
    Chip { name: "cortex-m0", title: "Cortex-M0+", part: "RP2040", megahertz: 133 },
    Chip { name: "cortex-m3", title: "Cortex-M3", part: "STM32F103", megahertz: 72 },
    Chip { name: "cortex-m4f", title: "Cortex-M4F", part: "STM32F411", megahertz: 100 },
    Chip { name: "rv32imc", title: "RV32IMC", part: "ESP32-C3", megahertz: 160 },
    Chip { name: "cortex-m7", title: "Cortex-M7", part: "STM32F746", megahertz: 216 },
    Chip { name: "cortex-m33", title: "Cortex-M33", part: "RP2350", megahertz: 150 },
    Chip { name: "hazard3", title: "Hazard3", part: "RP2350", megahertz: 150 },
];

/// The evaluations of a light.
const EVALUATIONS: [&str; 4] = ["fx16-quick", "fx16", "fx32", "f32"];

/// Instructions of a lit point on a Cortex-M0 in C, by the fastest floats in software that we know: see
/// "Floats in software" in `docs/PRICES.md`.
const FLOATS: f64 = 1733.0;

/// The kernel of a lit point.
const LIT: &str = "lit-inverse-square";

/// The parts of a picture beside codes and haze: the kernel of each, and the kernel without that part if it is counted
/// within another.
const PARTS: [(&str, &str, Option<&str>); 7] = [
    ("light", LIT, None),
    ("colours", "matte", Some("directional")),
    ("highlight", "lit-specular", Some("lit")),
    ("gobo", "lit-gobo", Some("lit")),
    ("shadow", "lit-shadow", Some("lit")),
    ("clip", "clip", None),
    ("hue", "keep-hue", None),
];

/// The kernel of a view ray through a beam.
const HAZE: &str = "haze";

/// The displays of the demo, each with the kernels of its codes without and with dither. Where one was counted, it stands
/// for both.
const DISPLAYS: [(&str, [&str; 2]); 11] = [
    ("gray1", ["gray1"; 2]),
    ("gray2", ["gray2"; 2]),
    ("gray4", ["gray4"; 2]),
    ("gray8", ["gray8"; 2]),
    ("rgb332", ["rgb332"; 2]),
    ("rgb444", ["rgb444"; 2]),
    ("rgb555", ["rgb555"; 2]),
    ("rgb565", ["rgb565", "rgb565-dithered"]),
    ("rgb666", ["rgb666"; 2]),
    ("rgb888", ["srgb", "dither"]),
    ("acep", ["palette"; 2]),
];

/// The stage of the recorded picture that depends on the evaluation of the light.
const LIGHT: &str = "frame.light";

/// The kernels of which pictures are counted, in every format on the first of the chips. A name may come twice.
pub fn kernels() -> impl Iterator<Item = &'static str> {
    let parts = PARTS.iter().flat_map(|(_, kernel, without)| [Some(*kernel), *without]).flatten();
    parts.chain([HAZE]).chain(DISPLAYS.iter().flat_map(|(_, codes)| *codes))
}

/// Writes the list into the demo's folder, from the record in `docs`.
pub(super) fn write(docs: &Path, site: &Path) -> Result<()> {
    let file = site.join(FILE);
    let list = list(&read(docs, "prices.json")?)?;
    fs::write(&file, list.to_string()).with_context(|| format!("cannot write {}", file.display()))
}

fn read(docs: &Path, name: &str) -> Result<Value> {
    let text = fs::read_to_string(docs.join(name)).with_context(|| format!("cannot read {name}"))?;
    serde_json::from_str(&text).with_context(|| format!("{name} is no JSON"))
}

/// The chips, each with the instructions and cycles of the recorded picture but for its lit points, and the
/// [`work`] of any picture.
/// `reached` is the number of lit points: what a shadow covers is lit before the shadow is known.
fn list(record: &Value) -> Result<Value> {
    let pixels = |name: &str| {
        let count = record["picture"]["figures"][name]["pixels"].as_f64();
        count.with_context(|| format!("the picture does not say how many pixels are {name}"))
    };
    let skipped = [("away", pixels("facing-away")?), ("outside", pixels("outside")?)];
    let chips = CHIPS.iter().map(|chip| {
        let figures = &record[chip.name]["figures"];
        let all = EVALUATIONS.iter().map(|evaluation| {
            let rest = |unit| rest(figures, skipped, evaluation, unit).context(chip.name);
            Ok((*evaluation, json!({ "instructions": rest("instructions")?, "cycles": rest("cycles")? })))
        });
        Ok(json!({
            "name": chip.name, "title": chip.title, "part": chip.part, "megahertz": chip.megahertz,
            "rest": all.collect::<Result<BTreeMap<_, _>>>()?,
        }))
    });
    Ok(json!({
        "work": work(&record[CHIPS[0].name]["figures"])?,
        "pixels": pixels("width")? * pixels("height")?,
        "reached": pixels("in-shadow")? + pixels("lit")?,
        "chips": chips.collect::<Result<Vec<_>>>()?,
    }))
}

/// Instructions on a Cortex-M0 of a picture, in each format and in the best floats. For each light and pixel: of a lit
/// point, of its colours, and what its highlight, gobo and shadow map add. For each pixel: of the two ways to limit
/// light, and of the codes of each display without and with dither. For each view ray through a beam: of haze, which
/// pictures of all formats have in floats.
///
/// Of the best floats a lit point was counted; the others are those of Rust's floats by the same factor.
fn work(figures: &Value) -> Result<Value> {
    let counted = |kernel: &str, format: &str| price(figures, kernel, format, "instructions");
    let best = FLOATS / counted(LIT, "f32")?;
    let haze = best * counted(HAZE, "f32")?;
    let mut work = BTreeMap::new();
    for (format, factor) in [("fx16", 1.0), ("fx32", 1.0), ("f32", best)] {
        let of = |kernel: &str| Ok::<_, anyhow::Error>(factor * counted(kernel, format)?);
        let mut all = serde_json::Map::new();
        for (part, kernel, without) in PARTS {
            all.insert(part.to_owned(), json!(of(kernel)? - without.map_or(Ok(0.0), of)?));
        }
        let displays = DISPLAYS.iter().map(|(name, [nearest, dithered])| {
            Ok((*name, json!({ "nearest": of(nearest)?, "dithered": of(dithered)? })))
        });
        all.insert("displays".to_owned(), json!(displays.collect::<Result<BTreeMap<_, _>>>()?));
        all.insert("haze".to_owned(), json!(haze));
        work.insert(format, all);
    }
    Ok(json!(work))
}

/// Instructions or cycles of the recorded picture but for its lit points; `None` if they were not counted.
/// `skipped` are the early-outs, with the number of their pixels.
fn rest(figures: &Value, skipped: [(&str, f64); 2], evaluation: &str, unit: &str) -> Result<Option<f64>> {
    let counted = picture(figures, unit, LIGHT);
    if counted == 0.0 {
        return Ok(None);
    }
    let mut rest = counted;
    for (kernel, pixels) in skipped {
        rest += pixels * price(figures, kernel, evaluation, unit)?;
    }
    Ok(Some(rest.round()))
}

/// The sum of the stages of the recorded picture but for one.
fn picture(figures: &Value, unit: &str, without: &str) -> f64 {
    let stages = figures.as_object().into_iter().flatten();
    let stages = stages.filter(|(name, _)| name.starts_with("frame.") && *name != without);
    stages.filter_map(|(_, figures)| figures[unit].as_f64()).sum()
}

fn price(figures: &Value, kernel: &str, evaluation: &str, unit: &str) -> Result<f64> {
    let name = format!("{kernel}.{evaluation}");
    figures[&name][unit].as_f64().with_context(|| format!("the record has no {unit} of {name}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::project;

    /// The recorded picture has the light by the quick evaluation of 16 bits, which is estimated
    /// here as for every other evaluation: point by point, where the picture lights rows and is
    /// cheaper by up to a third.
    #[test]
    fn the_estimate_of_a_picture_is_near_the_recorded_one() {
        let record = read(&project::root().join("docs"), "prices.json").unwrap();
        let list = list(&record).unwrap();
        let number = |value: &Value| value.as_f64().unwrap();
        for chip in list["chips"].as_array().unwrap() {
            let name = chip["name"].as_str().unwrap();
            let figures = &record[name]["figures"];
            for unit in ["instructions", "cycles"] {
                let counted = picture(figures, unit, "");
                if counted == 0.0 {
                    continue;
                }
                let point = price(figures, LIT, "fx16-quick", unit).unwrap();
                let estimated = number(&chip["rest"]["fx16-quick"][unit]) + number(&list["reached"]) * point;
                let error = estimated / counted - 1.0;
                assert!((-0.1..0.35).contains(&error), "{name}: {estimated} {unit}, {counted} were counted");
            }
        }
    }

    /// Every part of a picture in floats takes more instructions than in 16 bits.
    #[test]
    fn the_parts_of_a_picture_take_more_in_floats() {
        fn compare(part: &str, fixed: &Value, floats: &Value) {
            match (fixed.as_object(), fixed.as_f64(), floats.as_f64()) {
                (Some(parts), ..) => {
                    parts.iter().for_each(|(name, fixed)| compare(name, fixed, &floats[name]));
                }
                (_, Some(fixed), Some(floats)) if part == "haze" => assert_eq!(fixed, floats),
                (_, Some(fixed), Some(floats)) => {
                    assert!(0.0 < fixed && fixed < floats, "{part}: {fixed}, {floats} in floats");
                }
                _ => panic!("{part} is no number: {fixed}, {floats}"),
            }
        }
        let record = read(&project::root().join("docs"), "prices.json").unwrap();
        let work = work(&record[CHIPS[0].name]["figures"]).unwrap();
        compare("all", &work["fx16"], &work["f32"]);
        assert_eq!(work["f32"]["light"], FLOATS);
    }

    #[test]
    fn the_displays_are_those_of_the_renderer() {
        let source = fs::read_to_string(project::root().join("render/src/renderer/display.rs")).unwrap();
        let (_, list) = source.split_once("\noutputs! {").unwrap();
        let (list, _) = list.split_once("\n}").unwrap();
        let names = list.lines().filter_map(|line| Some(line.split_once(" = \"")?.1.split_once('"')?.0));
        assert_eq!(names.chain(["acep"]).collect::<Vec<_>>(), DISPLAYS.map(|(name, _)| name));
    }

    #[test]
    fn the_floats_are_those_of_the_price_list() {
        let prices = fs::read_to_string(project::root().join("docs/PRICES.md")).unwrap();
        assert!(prices.contains(&format!(
            "took {},{:03}, where gcc's",
            FLOATS as u32 / 1000,
            FLOATS as u32 % 1000
        )));
    }
}
