//! What the picture costs, as `docs/frame.json` has it.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};

use super::output::Output;
use tools::project;

/// How far instructions may be from those of another compiler.
const LEEWAY: f64 = 0.05;

/// The recorded counts of the picture.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Record {
    /// How many pixels it has.
    pub(super) pixels: u64,
    /// How many of them the light reaches, and what keeps it from the others.
    pub(super) light: String,
    /// The stages in their order.
    pub(super) stages: Vec<String>,
    /// What they cost, by board.
    pub(super) boards: BTreeMap<String, Counts>,
}

/// What the picture costs on a board.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Counts {
    pub(super) compiler: String,
    /// KiB of flash, rounded up: code and constants of the whole program. Panic messages embed
    /// the path of the checkout, so the exact size differs between checkouts.
    pub(super) kibibytes: u64,
    /// Of all pixels, by stage.
    pub(super) instructions: BTreeMap<String, u64>,
}

impl Counts {
    /// A program of which nothing has run.
    pub(super) fn new(compiler: &str, bytes: u64) -> Self {
        Self { compiler: compiler.to_owned(), kibibytes: bytes.div_ceil(1024), ..Self::default() }
    }

    /// Adds a row's stage.
    pub(super) fn add(&mut self, stage: &str, instructions: u64) {
        *self.instructions.entry(stage.to_owned()).or_default() += instructions;
    }
}

impl Record {
    /// A picture that nothing is known of but what it shows.
    pub(super) fn new(output: &Output) -> Self {
        let pixels = output.picture.pixels() as u64;
        Self { pixels, light: output.tally.clone(), stages: output.stages.clone(), boards: BTreeMap::new() }
    }

    /// Where the record is.
    pub(super) fn file() -> PathBuf {
        project::root().join("docs/frame.json")
    }

    /// The record that is checked in.
    pub(super) fn load() -> Result<Self> {
        let file = Self::file();
        let failed = || format!("cannot read {}", project::shown(&file));
        serde_json::from_str(&fs::read_to_string(&file).with_context(failed)?).with_context(failed)
    }

    /// The record as a text.
    pub(super) fn text(&self) -> Result<String> {
        Ok(serde_json::to_string_pretty(self)? + "\n")
    }

    /// Takes the boards that it lacks from another record.
    pub(super) fn take_missing(&mut self, other: Option<Self>) {
        for (board, counts) in other.unwrap_or_default().boards {
            self.boards.entry(board).or_insert(counts);
        }
    }
}

/// What differs between two records, on the boards of the new one; and what a reader should know
/// that is no difference.
pub(super) fn compare(old: &Record, new: &Record) -> (Vec<String>, Vec<String>) {
    let (mut differences, mut remarks) = (Vec::new(), Vec::new());
    if (old.pixels, &old.light, &old.stages) != (new.pixels, &new.light, &new.stages) {
        differences
            .push(format!("{} pixels, {}; recorded {}, {}", new.pixels, new.light, old.pixels, old.light));
    }
    for (board, now) in &new.boards {
        let Some(before) = old.boards.get(board) else {
            differences.push(format!("{board} is not recorded"));
            continue;
        };
        let is_same = before.compiler == now.compiler;
        if !is_same {
            let (now, before) = (&now.compiler, &before.compiler);
            let percent = 100.0 * LEEWAY;
            remarks.push(format!(
                "{board}: {now}, recorded by {before}: its counts may differ by {percent:.0} %"
            ));
        }
        let leeway = if is_same { 0.0 } else { LEEWAY };
        for stage in &new.stages {
            let [before, now] =
                [before, now].map(|counts| counts.instructions.get(stage).copied().unwrap_or(0));
            if now.abs_diff(before) as f64 > leeway * before as f64 {
                let word = if now > before { "worse" } else { "better" };
                differences.push(format!("{board}: {word}: {stage} {now} instructions, recorded {before}"));
            }
        }
        if is_same && before.kibibytes != now.kibibytes {
            differences.push(format!("{board}: {} KiB, recorded {}", now.kibibytes, before.kibibytes));
        }
    }
    (differences, remarks)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(compiler: &str, instructions: u64) -> Record {
        let mut counts = Counts::new(compiler, 4000);
        counts.add("light", instructions - 1);
        counts.add("light", 1);
        let boards = BTreeMap::from([("cortex-m0".to_owned(), counts)]);
        Record { pixels: 4, light: "4 lit".to_owned(), stages: vec!["light".to_owned()], boards }
    }

    #[test]
    fn what_is_written_is_read() {
        let record = record("rustc 1.96.0", 100);
        assert_eq!(serde_json::from_str::<Record>(&record.text().unwrap()).unwrap(), record);
        assert_eq!(record.boards["cortex-m0"].instructions["light"], 100);
    }

    #[test]
    fn one_instruction_more_or_less_is_told() {
        let old = record("rustc 1.96.0", 100);
        assert_eq!(compare(&old, &old), (vec![], vec![]));
        let (worse, _) = compare(&old, &record("rustc 1.96.0", 101));
        assert_eq!(worse, ["cortex-m0: worse: light 101 instructions, recorded 100"]);
        let (better, _) = compare(&old, &record("rustc 1.96.0", 99));
        assert!(better[0].contains("better"), "{better:?}");
    }

    #[test]
    fn another_compiler_has_five_percent_and_is_told_of() {
        let old = record("rustc 1.96.0", 100);
        let (differences, remarks) = compare(&old, &record("rustc 1.97.0", 105));
        assert!(differences.is_empty() && remarks[0].contains("1.97.0"), "{differences:?} {remarks:?}");
        assert_eq!(compare(&old, &record("rustc 1.97.0", 106)).0.len(), 1);
    }

    #[test]
    fn another_picture_board_or_size_is_told() {
        let old = record("rustc 1.96.0", 100);
        let mut other = old.clone();
        other.light = "3 lit".to_owned();
        assert!(compare(&old, &other).0[0].contains("3 lit"));
        let mut larger = old.clone();
        larger.boards.get_mut("cortex-m0").unwrap().kibibytes = 5;
        assert!(compare(&old, &larger).0[0].contains("5 KiB, recorded 4"));
        assert!(
            compare(&Record { boards: BTreeMap::new(), ..old.clone() }, &old).0[0].contains("not recorded")
        );
        let mut kept = Record { boards: BTreeMap::new(), ..old.clone() };
        kept.take_missing(Some(old.clone()));
        assert_eq!(kept, old);
    }
}
