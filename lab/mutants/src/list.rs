//! The list of mutants that no test can notice, each with its reason.

use std::collections::BTreeMap;

use anyhow::{Context, Result, ensure};

use crate::find::Mutant;

/// Reasons by entry: what [`Mutant::key`] returns, or a rule.
pub(crate) type Equivalents = BTreeMap<String, String>;

/// What a rule has in place of the parts that vary. `*` would be a product.
const ANY: &str = "<any>";

/// The list in the repository.
pub(crate) const LIST: &str = "lab/mutants/equivalent.txt";

/// Reads the list: lines `file, function: change`, each followed by indented lines with its reason.
/// `<any>` in an entry stands for any text. Lines that begin with `#` are remarks.
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

/// Whether an entry of the list holds this mutant.
pub(crate) fn lists(list: &Equivalents, key: &str) -> bool {
    list.contains_key(key) || list.keys().any(|entry| matches(entry, key))
}

/// Whether an entry is a mutant's key, or a rule that matches it.
pub(crate) fn matches(entry: &str, key: &str) -> bool {
    let Some((head, last)) = entry.rsplit_once(ANY) else { return entry == key };
    let mut rest = key;
    for (number, part) in head.split(ANY).enumerate() {
        let Some(at) = rest.find(part).filter(|at| number > 0 || *at == 0) else { return false };
        rest = &rest[at + part.len()..];
    }
    rest.ends_with(last)
}

impl Mutant {
    /// The mutant's line in the list. It has no line number, so that it survives changes elsewhere.
    pub fn key(&self) -> String {
        format!("{}, {}: {}", self.file, self.function, self.change)
    }
}
