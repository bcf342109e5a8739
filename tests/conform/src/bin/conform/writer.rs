//! Writes the file: a section for each model and format, with the hard cases first and then random
//! ones.

use std::fmt::Write;

use fixed::types::{I2F14, I2F30, I16F16, U18F14, U34F30};
use luminaire::{
    Fx16, Fx32,
    number::{Length, Light16, Light32},
};
use luminaire_conform::{Case, Evaluate, Input, Inputs, Kind, Word, each_model};
use luminaire_oracle::SplitMix64;

use super::scene::Scene;
use super::situation::{PARTS, Part, SEAMS, SITUATIONS, Seam};

/// Number of random scenes in each section.
const SCENES: usize = 12;

const PREFACE: &str = "\
# Conformance vectors of luminaire. README.md beside this file says what the models and their words are.
# Written by `cargo xtask conform --bless`; checked by `cargo xtask conform`.
";

/// The whole file.
pub(crate) fn file() -> String {
    let mut file = PREFACE.to_owned();
    each_model(&mut |model| {
        for (evaluate, format) in model.runs.iter().zip(model.formats()) {
            section(&mut file, &format!("{}{} {format}", model.kind, model.name), *evaluate);
        }
    });
    file
}

/// Words in the names of models, each with the word that it has replaced. A section's seed is made
/// from the old words, so that renaming a model keeps its scenes.
const FIRST_WORDS: [(&str, &str); 10] = [
    ("step", "cut-off"),
    ("quadratic", "blend"),
    ("inverted-power-4", "rim-4"),
    ("inverted-real-power", "real-rim"),
    ("cut-at", "hard-range"),
    ("gltf-range", "windowed"),
    ("gltf-range-without-range", "windowed-without-range"),
    ("filament-range", "squared-window"),
    ("difference-form-2-phong", "lyon-2-phong"),
    ("difference-form-3-blinn-phong", "lyon-3-blinn-phong"),
];

/// The name that the seed of a section is made from: the one that the section had first.
fn first_name(name: &str) -> String {
    let mut words: Vec<&str> = name.split(' ').collect();
    for word in &mut words {
        if let Some((_, first)) = FIRST_WORDS.iter().find(|(now, _)| now == word) {
            *word = first;
        }
    }
    words.join(" ")
}

fn section(file: &mut String, name: &str, evaluate: Evaluate) {
    // The seed depends only on the section's name, so that adding or removing other sections keeps
    // its scenes.
    let seed = first_name(name).bytes().fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    let mut random = SplitMix64(seed);
    let mut rows: Vec<(String, String)> = Vec::new();
    let mut header = String::new();
    let mut row = |scene: &Scene, seam: Option<(Seam, Part)>| {
        let mut source = Source { scene, seam, words: String::new(), names: String::new() };
        let outputs = Case::run(evaluate, &mut source).expect("a source has every input");
        header = source.names;
        format!("{} -> {}", source.words, outputs.as_str())
    };
    // Each hard case changes a random scene. If the change affects no input of the model, the case
    // is left out.
    let mut hard = |scene: &Scene, harder: &Scene, seam, name| {
        let (plain, words) = (row(scene, None), row(harder, seam));
        if words != plain {
            rows.push((words, name));
        }
    };
    for (name, situation) in SITUATIONS {
        let scene = Scene::new(&mut random);
        let mut harder = scene.clone();
        situation(&mut harder, &mut random);
        hard(&scene, &harder, None, format!(" # {name}"));
    }
    for (seam, part) in SEAMS.into_iter().flat_map(|seam| PARTS.map(|part| (seam, part))) {
        let scene = Scene::new(&mut random);
        hard(&scene, &scene, Some((seam, part)), format!(" # {}, {}", seam.name, part.0));
    }
    for _ in 0..SCENES {
        rows.push((row(&Scene::new(&mut random), None), String::new()));
    }
    // Writing to a string does not fail.
    let _ = writeln!(file, "\n[{name}]{header}");
    for (index, (words, name)) in rows.iter().enumerate() {
        if rows[..index].iter().all(|(earlier, _)| earlier != words) {
            let _ = writeln!(file, "{words}{name}");
        }
    }
}

/// Supplies the values of a scene as words, and records the words and the inputs' names.
struct Source<'a> {
    scene: &'a Scene,
    seam: Option<(Seam, Part)>,
    words: String,
    names: String,
}

impl Inputs for Source<'_> {
    fn word(&mut self, input: Input) -> Option<u64> {
        let seam = self.seam.filter(|(_, (_, takes))| takes(&input));
        let word = seam.map_or_else(|| stored(self.scene, &input), |(seam, _)| seam.word(&input));
        let digits = input.digits;
        let space = if self.words.is_empty() { "" } else { " " };
        let _ = write!(self.words, "{space}{word:0digits$x}");
        if input.component == 0 {
            let _ = write!(self.names, " {}:{}", input.name.replace(' ', "-"), input.format);
        }
        Some(word)
    }
}

/// The word that stands for a value of the scene.
fn stored(scene: &Scene, input: &Input) -> u64 {
    let name = if input.kind == Kind::Versine { "versine" } else { input.name };
    let value = scene.value(name, input.component);
    match input.format {
        "f32" => (value as f32).word(),
        "u32" => u64::from(value as u32),
        "i2f14" => Fx16::from(I2F14::saturating_from_num(value)).word(),
        "i2f30" => Fx32::from(I2F30::saturating_from_num(value)).word(),
        "i16f16" => Length::from(I16F16::saturating_from_num(value)).word(),
        "u18f14" => Light16::from(U18F14::saturating_from_num(value)).word(),
        "u34f30" => Light32::from(U34F30::saturating_from_num(value)).word(),
        // The scale of a versine depends on the cone, so any bits will do. The same scene gives the
        // same bits.
        "u3f29" | "u3f61" => {
            let bits = SplitMix64(value.to_bits()).bits();
            bits >> (64 - 4 * input.digits as u64 + bits % 24)
        }
        other => panic!("no word is made in {other}"),
    }
}
