//! `cargo xtask pick`: the prices by which `luminaire pick` chooses an evaluation.

use std::collections::BTreeMap;
use std::path::PathBuf;

use anyhow::Result;
use serde::{Deserialize, Serialize};

use crate::boards::board::{self, Board};
use crate::boards::laboratory::Laboratory;
use crate::boards::{Rp2040, cost, laboratory};
use crate::record::{self, Figure, Group, Record};
use tools::progress::Progress;
use tools::suite::Suite;

/// The options of `pick`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub struct PickOptions {
    /// Count on this one only: cortex-m0, cortex-m3, cortex-m4f or rv32imc; may be repeated
    #[arg(long = "target", value_name = "NAME", value_parser = Board::named)]
    pub boards: Vec<&'static Board>,
    /// Write the prices although they differ from those on record
    #[arg(long)]
    pub bless: bool,
}

/// The firmware program.
const PROGRAM: &str = "choose";

/// Adds a step for each board: the prices are those on record.
pub fn steps(suite: &mut Suite, boards: &[&'static Board]) {
    for &board in boards {
        suite.remarked(&format!("pick: the prices on {}", board.name), |progress| {
            record::check(&counted(&[board], progress)?)
        });
    }
}

/// The prices, by board.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
struct Prices(BTreeMap<String, OnBoard>);

/// The prices on a board.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
struct OnBoard {
    compiler: String,
    /// Instructions of a lit point, bytes of code, and cycles if they were counted, by edge,
    /// attenuation and evaluation.
    kernels: BTreeMap<String, (f64, u64, Option<f64>)>,
}

/// Counts, and compares with the record or writes it.
pub fn run(options: &PickOptions) -> Result<()> {
    let progress = Progress::Live;
    let boards = if options.boards.is_empty() { board::ALL.iter().collect() } else { options.boards.clone() };
    let mut prices = counted(&boards, &progress)?;
    if options.bless {
        for (board, old) in record::load::<Prices>()?.unwrap_or_default().0 {
            prices.0.entry(board).or_insert(old);
        }
        return record::write(&prices, true, &progress);
    }
    record::check(&prices)?.iter().for_each(|remark| println!("{remark}"));
    println!("the prices are those on record");
    Ok(())
}

/// Counts on boards. The results must be the host's.
fn counted(boards: &[&'static Board], progress: &Progress) -> Result<Prices> {
    let host = laboratory::on_the_host(PROGRAM, progress)?;
    let counts = boards.iter().map(|board| {
        let laboratory = Laboratory::with_program(PROGRAM, board, progress)?;
        let clock = Rp2040::for_board(board, progress)?;
        let costs = cost::measure(&laboratory, PROGRAM, &host, clock.as_ref())?;
        let thousandths = |value: f64| (value * 1000.0).round() / 1000.0;
        let price = |cost: &cost::Cost| {
            (cost.name(), (thousandths(cost.instructions), cost.bytes, cost.cycles.map(thousandths)))
        };
        let kernels = costs.kernels.iter().map(price).collect();
        Ok((board.name.to_owned(), OnBoard { compiler: costs.compiler, kernels }))
    });
    Ok(Prices(counts.collect::<Result<_>>()?))
}

impl Record for Prices {
    const FILE: &'static str = "cli/pick/prices.json";
    const COMMAND: &'static str = "cargo xtask pick";

    fn read(text: &str) -> Result<Self> {
        Ok(serde_json::from_str(text)?)
    }

    fn text(&self) -> Result<String> {
        // One line for each kernel, so that a `diff` shows which changed.
        let text = serde_json::to_string_pretty(self)?;
        Ok(text.replace("[\n        ", "[").replace(",\n        ", ", ").replace("\n      ]", "]") + "\n")
    }

    fn figures(&self) -> BTreeMap<String, Group> {
        let groups = self.0.iter().map(|(board, prices)| {
            let mut group = Group::of(&prices.compiler);
            for (kernel, (instructions, bytes, cycles)) in &prices.kernels {
                group.add(format!("{kernel}, instructions"), Figure::Instructions(*instructions));
                group.add(format!("{kernel}, bytes"), Figure::Bytes(*bytes));
                if let Some(cycles) = cycles {
                    group.add(format!("{kernel}, cycles"), Figure::Instructions(*cycles));
                }
            }
            (board.clone(), group)
        });
        groups.collect()
    }

    fn documents(&self) -> Result<Vec<(PathBuf, Vec<u8>)>> {
        Ok(Vec::new())
    }
}
