//! The prices, as `docs/effects.json` has them.

use std::collections::BTreeMap;
use std::path::PathBuf;

use anyhow::Result;
use luminaire::dynamic::Effect;
use serde::{Deserialize, Serialize};

use super::browser::Browser;
use super::{catalogue, page};
use crate::record::{Figure, Group, Record};
use tools::project;

/// The recorded figures of the effects.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct EffectList {
    /// Descriptions of the effects. They come from the catalogue, so they are written and never
    /// read.
    #[serde(skip_deserializing, serialize_with = "described")]
    effects: (),
    /// The prices, by board.
    pub(super) boards: BTreeMap<String, Prices>,
    /// The times in a browser, once they were measured.
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
    /// Instructions of an average pixel.
    pub(super) instructions: f64,
    /// The same of the program that is compiled for size.
    pub(super) instructions_for_size: f64,
    /// Cycles of an average pixel on the core of an RP2040, without wait states.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) cycles: Option<f64>,
    /// Bytes of flash, minus those of the empty program.
    pub(super) bytes: u64,
}

/// What an effect is, and which program shows it.
#[derive(Serialize)]
struct Description<'a> {
    title: &'a str,
    program: &'a str,
    /// The names of the effects in the library.
    effects: Vec<&'a str>,
    /// The program that differs only in lacking this effect.
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

impl Record for EffectList {
    const FILE: &'static str = "docs/effects.json";
    const COMMAND: &'static str = "cargo xtask effects";

    fn read(text: &str) -> Result<Self> {
        Ok(serde_json::from_str(text)?)
    }

    fn text(&self) -> Result<String> {
        Ok(serde_json::to_string_pretty(self)? + "\n")
    }

    /// The browser's times are not compared.
    fn figures(&self) -> BTreeMap<String, Group> {
        let mut figures = BTreeMap::new();
        for (board, prices) in &self.boards {
            let [mut group, mut cycles] = [(); 2].map(|()| Group::of(&prices.compiler));
            group.add("the number format", Figure::Text(prices.format.clone()));
            for (program, price) in &prices.prices {
                group.add(format!("{program}, instructions"), Figure::Instructions(price.instructions));
                let for_size = Figure::Instructions(price.instructions_for_size);
                group.add(format!("{program}, instructions for size"), for_size);
                group.add(format!("{program}, bytes"), Figure::Bytes(price.bytes));
                if let Some(counted) = price.cycles {
                    cycles.add(format!("{program}, cycles"), Figure::Instructions(counted));
                }
            }
            if !cycles.is_empty() {
                figures.insert(format!("{board} by rp2040js"), cycles);
            }
            figures.insert(board.clone(), group);
        }
        figures
    }

    fn documents(&self) -> Result<Vec<(PathBuf, Vec<u8>)>> {
        Ok(vec![(project::root().join("docs/EFFECTS.md"), page::write(self)?.into_bytes())])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{check_documents, load};

    #[test]
    fn documents_are_those_that_the_record_gives() {
        check_documents(&load::<EffectList>().unwrap().expect("a record")).unwrap();
    }

    #[test]
    fn what_is_written_is_read() {
        let mut prices = Prices { compiler: "rustc 1.96.0".to_owned(), ..Prices::default() };
        let price = Price { instructions: 100.25, instructions_for_size: 120.5, cycles: None, bytes: 400 };
        prices.prices.insert("spot-soft-lambert".to_owned(), price);
        let boards = BTreeMap::from([("cortex-m0".to_owned(), prices)]);
        let list = EffectList { boards, ..EffectList::default() };
        let text = list.text().unwrap();
        assert_eq!(EffectList::read(&text).unwrap(), list);
        assert!(text.contains(r#""over": "spot-soft-lambert""#), "{text}");
        assert_eq!(list.figures()["cortex-m0"], {
            let mut group = Group::of("rustc 1.96.0");
            group.add("the number format", Figure::Text(String::new()));
            group.add("spot-soft-lambert, instructions", Figure::Instructions(100.25));
            group.add("spot-soft-lambert, instructions for size", Figure::Instructions(120.5));
            group.add("spot-soft-lambert, bytes", Figure::Bytes(400));
            group
        });
    }
}
