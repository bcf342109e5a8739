//! `cargo xtask effects`: what each effect adds to the price of a pixel, and to a firmware's flash.

mod browser;
pub(crate) mod catalogue;
mod documents;
mod gate;
mod page;
mod prices;
mod record;
pub mod steps;

use std::fs;

use anyhow::{Context, Result, bail, ensure};

use self::prices::{STANDS, Stand};
use self::record::Record;
use tools::progress::Progress;
use tools::project;

/// The options of `effects`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub struct EffectsOptions {
    /// Compare with what is recorded instead, and write nothing
    #[arg(long)]
    pub check: bool,
    /// Write the prices also where they differ from those recorded
    #[arg(long, conflicts_with = "check")]
    pub bless: bool,
    /// Time a browser again, which wants a quiet machine
    #[arg(long, conflicts_with = "check")]
    pub time: bool,
}

/// Counts, compares, and writes the record and the page.
pub fn run(options: &EffectsOptions) -> Result<()> {
    let progress = Progress::Live;
    if options.check {
        for stand in &STANDS {
            check(stand, &progress)?.iter().for_each(|remark| println!("{remark}"));
        }
        println!("the prices are those recorded");
        return Ok(());
    }
    let mut new = Record::default();
    for stand in &STANDS {
        new.boards.insert(stand.board.to_owned(), prices::count(stand, &progress)?);
    }
    if let Some(old) = Record::load()? {
        new.browser.clone_from(&old.browser);
        let verdict = gate::compare(&old, &new);
        verdict.remarks.iter().chain(&verdict.differences).for_each(|line| println!("{line}"));
        let number = verdict.differences.len();
        ensure!(
            number == 0 || options.bless,
            "{number} prices differ from those recorded: `cargo xtask effects --bless` accepts them"
        );
    }
    if options.time {
        new.browser = Some(browser::time(&progress)?);
    }
    for (file, text) in documents::made_of(&new)? {
        fs::write(&file, text).with_context(|| format!("cannot write {}", project::shown(&file)))?;
        progress.say("Written", project::shown(&file));
    }
    Ok(())
}

/// Compares the prices of one board with those recorded, and the documents with what would be made
/// of the record. Returns the remarks of a comparison that has passed.
fn check(stand: &Stand, progress: &Progress) -> Result<Vec<String>> {
    let old = Record::load()?.context("nothing is recorded: `cargo xtask effects` does it")?;
    for (file, text) in documents::made_of(&old)? {
        let shown = project::shown(&file);
        let found = fs::read_to_string(&file).with_context(|| format!("cannot read {shown}"))?;
        ensure!(found == text, "{shown} is not what is recorded: `cargo xtask effects` writes it");
    }
    let mut new = Record::default();
    new.boards.insert(stand.board.to_owned(), prices::count(stand, progress)?);
    let verdict = gate::compare(&old, &new);
    if !verdict.differences.is_empty() {
        let told = verdict.differences.join("\n    ");
        bail!("the prices are not those recorded; `cargo xtask effects --bless` accepts them\n    {told}");
    }
    Ok(verdict.remarks)
}
