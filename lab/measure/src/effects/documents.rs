//! What is made of the prices: the record and the page. Nothing else decides on their text, so that
//! they can be compared with it.

use std::path::PathBuf;

use anyhow::Result;

use super::page;
use super::record::Record;
use tools::project;

/// Every file with the text that it should have.
pub(super) fn made_of(record: &Record) -> Result<[(PathBuf, String); 2]> {
    let page = project::root().join("docs/EFFECTS.md");
    Ok([(Record::file(), record.text()?), (page, page::write(record)?)])
}
