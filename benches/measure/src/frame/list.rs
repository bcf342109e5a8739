//! What the picture costs, as `docs/frame.json` has it.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};
use tools::project;

use super::output::Output;
use super::part;
use super::picture::Picture;
use crate::record::{Figure, Group, Record, replaced};

/// What the picture costs, and the picture itself, which is stored in a separate file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct StageList {
    /// Number of pixels of the picture.
    pub(super) pixels: u64,
    /// How many pixels the light reaches, and why it does not reach the others.
    pub(super) light: String,
    /// The stages in their order.
    pub(super) stages: Vec<String>,
    /// What the stages cost, by board.
    pub(super) boards: BTreeMap<String, Counts>,
    #[serde(skip)]
    pub(super) picture: Picture,
}

/// What the picture costs on a board.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Counts {
    pub(super) compiler: String,
    /// KiB of flash, rounded up: code and constants of the whole program. Panic messages embed
    /// the path of the checkout, so the exact size differs between checkouts.
    pub(super) kibibytes: u64,
    /// Instructions for all pixels, by stage.
    pub(super) instructions: BTreeMap<String, u64>,
    /// Cycles for all pixels on the core of an RP2040 without wait states, by stage.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(super) cycles: BTreeMap<String, u64>,
}

impl Counts {
    /// The counts of a program before any instruction was counted.
    pub(super) fn new(compiler: &str, bytes: u64) -> Self {
        Self { compiler: compiler.to_owned(), kibibytes: bytes.div_ceil(1024), ..Self::default() }
    }

    /// Adds the instructions of one stage of a row.
    pub(super) fn add(&mut self, stage: &str, instructions: u64) {
        *self.instructions.entry(stage.to_owned()).or_default() += instructions;
    }
}

impl StageList {
    /// A picture without the costs of a board.
    pub(super) fn new(output: Output) -> Self {
        let Output { stages, picture, tally: light } = output;
        Self { pixels: picture.pixels() as u64, light, stages, boards: BTreeMap::new(), picture }
    }

    /// Takes the boards that this list lacks from another.
    pub(super) fn take_missing(&mut self, other: Option<Self>) {
        for (board, counts) in other.unwrap_or_default().boards {
            self.boards.entry(board).or_insert(counts);
        }
    }
}

fn picture_file() -> PathBuf {
    project::root().join("docs/frame.png")
}

impl Record for StageList {
    const FILE: &'static str = "docs/frame.json";
    const COMMAND: &'static str = "cargo xtask frame";

    fn read(text: &str) -> Result<Self> {
        Ok(Self { picture: Picture::read(&picture_file())?, ..serde_json::from_str(text)? })
    }

    fn text(&self) -> Result<String> {
        Ok(serde_json::to_string_pretty(self)? + "\n")
    }

    fn figures(&self) -> BTreeMap<String, Group> {
        let mut picture = Group::exact();
        picture.add("stages", Figure::Text(self.stages.join(", ")));
        picture.add("reached by the light", Figure::Text(self.light.clone()));
        for (number, row) in self.picture.rows().enumerate() {
            picture.add(format!("row {number:3}"), Figure::Text(row));
        }
        let mut figures = BTreeMap::from([("picture".to_owned(), picture)]);
        for (board, counts) in &self.boards {
            let mut group = Group::of(&counts.compiler);
            for (stage, &instructions) in &counts.instructions {
                group.add(format!("{stage}, instructions"), Figure::Instructions(instructions as f64));
            }
            group.add("KiB of flash", Figure::Bytes(counts.kibibytes));
            let mut cycles = Group::of(&counts.compiler);
            for (stage, &counted) in &counts.cycles {
                cycles.add(format!("{stage}, cycles"), Figure::Instructions(counted as f64));
            }
            if !cycles.is_empty() {
                figures.insert(format!("{board} by rp2040js"), cycles);
            }
            figures.insert(board.clone(), group);
        }
        figures
    }

    fn documents(&self) -> Result<Vec<(PathBuf, Vec<u8>)>> {
        let readme = project::root().join("benches/firmware/README.md");
        let text = fs::read_to_string(&readme).context("cannot read benches/firmware/README.md")?;
        let text = replaced(&text, part::LINES, &part::write(self)).context("benches/firmware/README.md")?;
        Ok(vec![(readme, text.into_bytes()), (picture_file(), self.picture.png()?)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{check_documents, load};

    #[test]
    fn documents_are_those_that_the_record_gives() {
        check_documents(&load::<StageList>().unwrap().expect("a record")).unwrap();
    }

    #[test]
    fn counts_are_added_up_and_compared_by_stage() {
        let mut counts = Counts::new("rustc 1.96.0", 4000);
        counts.add("light", 99);
        counts.add("light", 1);
        let boards = BTreeMap::from([("cortex-m0".to_owned(), counts)]);
        let list = StageList { boards, ..StageList::default() };
        let mut group = Group::of("rustc 1.96.0");
        group.add("light, instructions", Figure::Instructions(100.0));
        group.add("KiB of flash", Figure::Bytes(4));
        assert_eq!(list.figures()["cortex-m0"], group);
        let mut kept = StageList::default();
        kept.take_missing(Some(list.clone()));
        assert_eq!(kept, list);
    }
}
