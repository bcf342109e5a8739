//! The file of the conformance vectors.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use tools::progress::Progress;
use tools::{command, project};

use super::target;
use crate::record::{self, Figure, Group, Record};

/// The text of the file.
#[derive(Debug, PartialEq)]
pub(super) struct Vectors(String);

/// The folder that the file is in.
pub(super) fn folder() -> PathBuf {
    project::root().join("tests/conform")
}

pub(super) fn path() -> PathBuf {
    project::root().join(Vectors::FILE)
}

impl Vectors {
    /// Loads the file that is under version control.
    pub(super) fn load() -> Result<Self> {
        record::load()?.context("there are no conformance vectors: write them with --bless")
    }

    /// Generates the vectors with the results of this machine.
    pub(super) fn generate(progress: &Progress) -> Result<Self> {
        let program = target::host(&[], "debug", progress)?;
        let vectors = Self(command::answer(Command::new(program).arg("generate"))? + "\n");
        ensure!(vectors.cases() > 0, "no case was generated");
        Ok(vectors)
    }

    /// The number of cases of the file.
    pub(super) fn cases(&self) -> usize {
        self.rows().count()
    }

    /// The cases: section, inputs and outputs.
    fn rows(&self) -> impl Iterator<Item = (&str, &str, &str)> {
        let mut section = "";
        self.0.lines().filter_map(move |line| {
            let line = line.split('#').next().unwrap_or_default().trim_end();
            if let Some(header) = line.strip_prefix('[') {
                section = header.split(']').next().unwrap_or_default();
            }
            let (inputs, outputs) = line.split_once(" -> ")?;
            Some((section, inputs, outputs))
        })
    }
}

impl Record for Vectors {
    const FILE: &'static str = "tests/conform/vectors.txt";
    const COMMAND: &'static str = "cargo xtask conform";

    fn read(text: &str) -> Result<Self> {
        Ok(Self(text.to_owned()))
    }

    fn text(&self) -> Result<String> {
        Ok(self.0.clone())
    }

    fn figures(&self) -> BTreeMap<String, Group> {
        let mut sections = BTreeMap::<_, Group>::new();
        for (section, inputs, outputs) in self.rows() {
            sections.entry(section.to_owned()).or_default().add(inputs, Figure::Text(outputs.to_owned()));
        }
        sections
    }

    fn documents(&self) -> Result<Vec<(PathBuf, Vec<u8>)>> {
        Ok(Vec::new())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases_are_compared_by_section_and_inputs() {
        let text = "# a -> comment\n[spot fx16] point\n0001 -> 4000 # on the axis\n0002 -> 0000\n";
        let vectors = Vectors::read(text).unwrap();
        let mut section = Group::exact();
        section.add("0001", Figure::Text("4000".to_owned()));
        section.add("0002", Figure::Text("0000".to_owned()));
        assert_eq!(vectors.figures(), BTreeMap::from([("spot fx16".to_owned(), section)]));
        assert_eq!(vectors.cases(), 2);
    }
}
