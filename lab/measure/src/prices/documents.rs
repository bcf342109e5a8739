//! What is made of the price list: the list itself, the page, the pictures and the README's part.
//! Nothing else decides on their text, so that they can be compared with it.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result};

use super::list::PriceList;
use super::target::Target;
use super::{page, plot, summary};
use tools::project;

/// Every file with the text that it should have.
pub(crate) fn made_of(list: &PriceList) -> Result<Vec<(PathBuf, String)>> {
    let docs = project::root().join("docs");
    let readme = project::root().join("README.md");
    let text = fs::read_to_string(&readme).context("cannot read README.md")?;
    let mut files = vec![
        (PriceList::file(), list.text()?),
        (docs.join("ACCURACY-VS-COST.md"), page::write(list)),
        (readme, summary::replaced(&text, list).context("README.md")?),
    ];
    for target in measured(list) {
        files.push((docs.join(picture(&target)), plot::draw(list, &target)));
    }
    Ok(files)
}

/// The targets that the list has costs of, in the order of the page.
pub(super) fn measured(list: &PriceList) -> Vec<Target> {
    Target::all().into_iter().filter(|target| list.meta.targets.contains_key(target.name())).collect()
}

/// The file name of a target's picture.
pub(super) fn picture(target: &Target) -> String {
    format!("accuracy-vs-cost-{}.svg", target.name())
}
