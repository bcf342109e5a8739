//! The list of mutants that no test can notice, each with its reason.

use std::collections::BTreeMap;

use anyhow::{Context, Result, ensure};

use crate::find::Mutant;

/// Reasons by what [`Mutant::key`] returns.
pub(crate) type Equivalents = BTreeMap<String, String>;

/// The list in the repository.
pub(crate) const LIST: &str = "lab/mutants/equivalent.txt";

/// Reads the list: lines `file, function: change`, each followed by indented lines with its reason.
/// Lines that begin with `#` are remarks.
pub(crate) fn parse(text: &str) -> Result<Equivalents> {
    let mut list = Equivalents::new();
    let mut last = None;
    for line in text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#')) {
        if line.starts_with(' ') {
            let key: &String =
                last.as_ref().with_context(|| format!("`{line}`: expected a mutant before it"))?;
            let reason = list.entry(key.clone()).or_default();
            *reason = format!("{reason} {}", line.trim()).trim_start().to_owned();
        } else {
            ensure!(list.insert(line.to_owned(), String::new()).is_none(), "`{line}`: listed twice");
            last = Some(line.to_owned());
        }
    }
    let without = list.iter().find(|(_, reason)| reason.is_empty());
    ensure!(without.is_none(), "{without:?}: expected a reason below it");
    Ok(list)
}

impl Mutant {
    /// The mutant's line in the list. It has no line number, so that it survives changes elsewhere.
    pub fn key(&self) -> String {
        format!("{}, {}: {}", self.file, self.function, self.change)
    }
}
