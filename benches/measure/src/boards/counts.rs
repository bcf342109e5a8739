//! Reads the counter's file: how often each address was executed, by region.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

/// The executions in one region, by address.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Region {
    executions: BTreeMap<u64, u64>,
}

impl Region {
    /// All instructions executed.
    pub(crate) fn instructions(&self) -> u64 {
        self.executions.values().sum()
    }

    /// Each address with its executions.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (u64, u64)> {
        self.executions.iter().map(|(address, count)| (*address, *count))
    }
}

impl FromIterator<(u64, u64)> for Region {
    fn from_iter<I: IntoIterator<Item = (u64, u64)>>(executions: I) -> Self {
        Self { executions: executions.into_iter().collect() }
    }
}

/// Reads the regions from the counter's file. An error if the file has a region beyond the first
/// `number`.
pub(crate) fn read(file: &Path, number: usize) -> Result<Vec<Region>> {
    let text = fs::read_to_string(file).context("the counter has written nothing")?;
    parse(&text, number).with_context(|| format!("{} is not what the counter writes", file.display()))
}

/// Parses the counter's file, in which a region without executed instructions has no line.
fn parse(text: &str, number: usize) -> Result<Vec<Region>> {
    let mut regions = vec![Region::default(); number];
    for line in text.lines() {
        let mut words = line.split(' ');
        let mut word = || words.next().with_context(|| format!("a word is missing: {line}"));
        let region: usize = word()?.parse()?;
        let address = u64::from_str_radix(word()?, 16)?;
        let count = word()?.parse()?;
        let region = regions.get_mut(region).with_context(|| format!("a region too many: {line}"))?;
        region.executions.insert(address, count);
    }
    Ok(regions)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regions_are_read_also_where_they_are_empty() {
        let regions = parse("1 10a 3\n1 10c 4\n2 10a 1\n", 4).unwrap();
        assert_eq!(regions.iter().map(Region::instructions).collect::<Vec<_>>(), [0, 7, 1, 0]);
        assert_eq!(regions[1].iter().collect::<Vec<_>>(), [(0x10a, 3), (0x10c, 4)]);
    }

    #[test]
    fn a_region_too_many_or_a_broken_line_is_an_error() {
        for text in ["2 10a 1\n", "0 10a\n", "0 xyz 1\n"] {
            assert!(parse(text, 2).is_err(), "{text}");
        }
    }
}
