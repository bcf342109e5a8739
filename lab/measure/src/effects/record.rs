//! The prices, as `docs/effects.json` has them.

use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::PathBuf;
use std::{fs, io};

use anyhow::{Context, Result};
use luminaire::dynamic::Effect;
use serde::{Deserialize, Serialize};

use super::browser::Browser;
use super::catalogue;
use tools::project;

/// The recorded figures of the effects.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Record {
    /// What they are. This is the catalogue's part, and only written.
    #[serde(skip_deserializing, serialize_with = "described")]
    effects: (),
    /// What they cost, by board.
    pub(super) boards: BTreeMap<String, Prices>,
    /// What they take in a browser, once that was timed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) browser: Option<Browser>,
}

/// The prices on a board, and what they depend on.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Prices {
    /// The number format.
    pub(super) format: String,
    pub(super) compiler: String,
    pub(super) runs_on: String,
    /// By the name of the program.
    pub(super) prices: BTreeMap<String, Price>,
}

/// What a program costs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Price {
    /// An average pixel's.
    pub(super) instructions: f64,
    /// Of flash, over the empty program.
    pub(super) bytes: u64,
}

/// What an effect is, and which program shows it.
#[derive(Serialize)]
struct Description<'a> {
    title: &'a str,
    program: &'a str,
    /// The names of the library.
    effects: Vec<&'a str>,
    /// The program that lacks them, and nothing else.
    #[serde(skip_serializing_if = "Option::is_none")]
    over: Option<&'a str>,
    what: &'a str,
}

fn described<S: serde::Serializer>((): &(), serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(catalogue::entries().map(|entry| Description {
        title: entry.title,
        program: entry.program,
        effects: entry.effects.iter().map(Effect::name).collect(),
        over: entry.over,
        what: entry.what,
    }))
}

impl Record {
    /// Where the record is.
    pub(super) fn file() -> PathBuf {
        project::root().join("docs/effects.json")
    }

    /// The record that is checked in, if there is one.
    pub(super) fn load() -> Result<Option<Self>> {
        let file = Self::file();
        let failed = || format!("cannot read {}", project::shown(&file));
        let text = match fs::read_to_string(&file) {
            Err(error) if is_missing(&error) => return Ok(None),
            text => text.with_context(failed)?,
        };
        serde_json::from_str(&text).with_context(failed)
    }

    /// The record as a text.
    pub(super) fn text(&self) -> Result<String> {
        Ok(serde_json::to_string_pretty(self)? + "\n")
    }
}

fn is_missing(error: &io::Error) -> bool {
    error.kind() == ErrorKind::NotFound
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// One program on one board.
    pub(crate) fn record(compiler: &str, program: &str, instructions: f64, bytes: u64) -> Record {
        let mut prices = Prices { compiler: compiler.to_owned(), ..Prices::default() };
        prices.prices.insert(program.to_owned(), Price { instructions, bytes });
        let mut record = Record::default();
        record.boards.insert("cortex-m0".to_owned(), prices);
        record
    }

    #[test]
    fn what_is_written_is_read() {
        let record = record("rustc 1.96.0", "spot-soft-lambert", 100.25, 400);
        let text = record.text().unwrap();
        assert_eq!(serde_json::from_str::<Record>(&text).unwrap(), record);
        assert!(text.contains(r#""over": "spot-soft-lambert""#), "{text}");
    }
}
