//! `cargo xtask effects`: what each effect adds to the price of a pixel, and to a firmware's flash.

mod browser;
pub(crate) mod catalogue;
mod list;
mod page;
mod prices;
pub mod steps;

use anyhow::Result;

use self::list::EffectList;
use self::prices::{STANDS, Stand};
use crate::record;
use tools::progress::Progress;

/// The options of `effects`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub struct EffectsOptions {
    /// Compare with what is recorded instead, and write nothing
    #[arg(long)]
    pub check: bool,
    /// Write the prices also where they differ from those recorded
    #[arg(long, conflicts_with = "check")]
    pub bless: bool,
    /// Time the effects in a browser again, which requires an otherwise idle machine
    #[arg(long, conflicts_with = "check")]
    pub time: bool,
}

/// Counts, compares with the record, and writes the record and the page.
pub fn run(options: &EffectsOptions) -> Result<()> {
    let progress = Progress::Live;
    if options.check {
        for stand in &STANDS {
            check(stand, &progress)?.iter().for_each(|remark| println!("{remark}"));
        }
        println!("the prices are those on record");
        return Ok(());
    }
    let mut new = EffectList::default();
    for stand in &STANDS {
        new.boards.insert(stand.board.to_owned(), prices::count(stand, &progress)?);
    }
    new.browser = if options.time {
        Some(browser::time(&progress)?)
    } else {
        record::load::<EffectList>()?.and_then(|old| old.browser)
    };
    record::write(&new, options.bless, &progress)
}

/// Compares the prices of one board with the record. Returns remarks if the comparison has passed.
fn check(stand: &Stand, progress: &Progress) -> Result<Vec<String>> {
    let mut new = EffectList::default();
    new.boards.insert(stand.board.to_owned(), prices::count(stand, progress)?);
    record::check(&new)
}
