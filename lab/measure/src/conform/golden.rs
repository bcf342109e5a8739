//! The file of the conformance vectors.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, ensure};

use super::target;
use tools::command;
use tools::progress::Progress;
use tools::project;

/// Maximum number of changed cases that are printed.
const SHOWN: usize = 5;

/// The folder that the file is in.
pub(crate) fn folder() -> PathBuf {
    project::root().join("lab/conform")
}

pub(crate) fn path() -> PathBuf {
    folder().join("vectors.txt")
}

/// How many cases the file has.
pub(crate) fn cases() -> Result<usize> {
    let file =
        fs::read_to_string(path()).context("there are no conformance vectors: write them with --bless")?;
    Ok(rows(&file).count())
}

/// Writes the file with what this machine computes; tells what changed.
pub(crate) fn bless(progress: &Progress) -> Result<String> {
    let program = target::host(&[], "debug", progress)?;
    let mut file = command::answer(Command::new(program).arg("generate"))?;
    file.push('\n');
    ensure!(rows(&file).next().is_some(), "no case was generated");
    let former = fs::read_to_string(path()).unwrap_or_default();
    fs::write(path(), &file).with_context(|| format!("cannot write {}", path().display()))?;
    Ok(changes(&former, &file))
}

/// What is different between two files: cases of the same inputs with other outputs, new cases, and
/// lost ones.
fn changes(former: &str, file: &str) -> String {
    let old: BTreeMap<_, _> = rows(former).collect();
    let new: BTreeMap<_, _> = rows(file).collect();
    let changed: Vec<_> = new
        .iter()
        .filter_map(|(key, now)| old.get(key).filter(|was| *was != now).map(|was| (key, was, now)))
        .collect();
    let added = new.keys().filter(|key| !old.contains_key(*key)).count();
    let lost = old.keys().filter(|key| !new.contains_key(*key)).count();
    let mut text = String::new();
    let mut sections: BTreeMap<&str, usize> = BTreeMap::new();
    // Writing to a string does not fail.
    for ((section, inputs), was, now) in changed.iter().take(SHOWN) {
        let _ = writeln!(text, "{section}: {inputs} -> {now}, before {was}");
    }
    for ((section, _), ..) in &changed {
        *sections.entry(section).or_default() += 1;
    }
    for (section, count) in sections {
        let _ = writeln!(text, "{section}: {count} changed");
    }
    let _ = writeln!(text, "{} cases: {} changed, {added} new, {lost} gone", new.len(), changed.len());
    text
}

/// The cases: section and inputs, and outputs.
fn rows(file: &str) -> impl Iterator<Item = ((&str, &str), &str)> {
    let mut section = "";
    file.lines().filter_map(move |line| {
        let line = line.split('#').next().unwrap_or_default().trim_end();
        if let Some(header) = line.strip_prefix('[') {
            section = header.split(']').next().unwrap_or_default();
        }
        let (inputs, outputs) = line.split_once(" -> ")?;
        Some(((section, inputs), outputs))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_is_told_by_section() {
        let former = "# a -> comment\n[spot fx16] point\n0001 -> 4000 # on the axis\n0002 -> 0000\n";
        let file = "[spot fx16] point\n0001 -> 3fff # on the axis\n0003 -> 0000\n";
        let told = changes(former, file);
        assert!(told.contains("spot fx16: 0001 -> 3fff, before 4000\nspot fx16: 1 changed\n"), "{told}");
        assert!(told.ends_with("2 cases: 1 changed, 1 new, 1 gone\n"), "{told}");
        assert!(changes(file, file).ends_with("2 cases: 0 changed, 0 new, 0 gone\n"));
    }
}
