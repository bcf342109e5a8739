//! `cargo xtask size`: what each effect takes of a microcontroller's flash.

pub(crate) mod effects;
pub mod program;
mod proof;
mod public;
mod report;
pub mod steps;

use anyhow::Result;

use crate::boards::Board;
use effects::{Effects, Format};
use report::Report;
use tools::progress::Progress;

/// The options of `size`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub struct SizeOptions {
    /// Print {target: {format: {effect: bytes}}} instead of the table
    #[arg(long)]
    pub json: bool,
}

/// The smallest processor, one with a floating point unit, and a RISC-V.
const BOARDS: [&str; 3] = ["cortex-m0", "cortex-m4f", "rv32imc"];

/// Builds every effect in every format for each target, and prints the bytes.
pub fn run(options: &SizeOptions) -> Result<()> {
    let progress = Progress::Live;
    let mut report = Report::default();
    for name in BOARDS {
        let board = Board::named(name).map_err(anyhow::Error::msg)?;
        for format in Format::ALL {
            let step =
                progress.begin("Building", format_args!("the effects in {} for {name}", format.name()));
            report.add(name, format.name(), Effects::build(board, format, &progress)?.bytes()?);
            step.done();
        }
    }
    if options.json {
        println!("{}", report.json())
    } else {
        print!("{report}")
    }
    Ok(())
}
