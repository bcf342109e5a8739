//! The record beside the documents that show its figures: their check, and their update.

mod effects;
mod memory;
mod picker;
mod prices;
mod rivals;
mod summary;
mod text;
mod worst;

use std::fs;

use anyhow::{Context, Result, ensure};
use tools::progress::Progress;
use tools::project;

use crate::plot;
use crate::record::{FILE, Record};
pub(crate) use picker::kernels;

/// The command that writes the record and the documents.
const COMMAND: &str = "cargo xtask measure --bless";

const FIRMWARE: &str = "benches/firmware/README.md";
const C: &str = "export/c/README.md";

/// Fails if a figure that was measured now differs from the record, or if a document is not the one
/// that the record gives. Otherwise returns remarks.
pub(crate) fn check(now: &Record) -> Result<Vec<String>> {
    let old = Record::load()?;
    let [differences, remarks] = old.compare(now);
    ensure!(differences.is_empty(), "{FILE}: not what is measured:\n    {}", differences.join("\n    "));
    for (file, content) in files(&old)? {
        let found = fs::read_to_string(project::root().join(file)).context(file)?;
        ensure!(found == content, "{file} is not what {FILE} says: `{COMMAND}` writes it");
    }
    Ok(remarks)
}

/// Writes what was measured now, with the other groups on record, and the documents. Differences are
/// printed, and without `bless` they are an error and nothing is written.
pub(crate) fn write(now: Record, bless: bool, progress: &Progress) -> Result<()> {
    let mut record = Record::load()?;
    let [differences, remarks] = record.compare(&now);
    remarks.iter().chain(&differences).for_each(|line| println!("{line}"));
    ensure!(differences.is_empty() || bless, "{FILE} is not what is measured: `{COMMAND}` accepts it");
    record.0.extend(now.0);
    for (file, content) in files(&record)? {
        fs::write(project::root().join(file), content).with_context(|| format!("cannot write {file}"))?;
        progress.say("Written", file);
    }
    Ok(())
}

/// The record and every document, as its path below the project's folder and its content.
fn files(record: &Record) -> Result<[(&'static str, String); 9]> {
    Ok([
        ("docs/ACCURACY-VS-COST.md", prices::answer(record)),
        ("docs/PRICES.md", prices::list(record)),
        ("docs/EFFECTS.md", effects::page(record)?),
        (plot::FILE, plot::draw(record)),
        ("cli/pick/prices.json", picker::prices(record)?),
        ("README.md", inserted("README.md", "prices", &summary::readme(record))?),
        (FIRMWARE, inserted(FIRMWARE, "frame", &summary::frame(record))?),
        (C, inserted(C, "prices", &summary::calls(record))?),
        (FILE, record.text()?),
    ])
}

/// A document with the part between two lines replaced.
fn inserted(file: &str, name: &str, part: &str) -> Result<String> {
    let text = fs::read_to_string(project::root().join(file)).context(file.to_owned())?;
    let (begin, end) =
        (format!("<!-- {name}: written by `cargo xtask measure` -->\n"), format!("<!-- end of {name} -->"));
    let (before, rest) = text.split_once(&begin).with_context(|| format!("{file} has no line {begin}"))?;
    let (_, after) = rest.split_once(&end).with_context(|| format!("{file} has no line {end}"))?;
    Ok(format!("{before}{begin}\n{part}\n{end}{after}"))
}

#[test]
fn documents_are_those_that_the_record_gives() {
    check(&Record::default()).unwrap();
}
