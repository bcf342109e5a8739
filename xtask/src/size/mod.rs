//! `cargo xtask size`: what each effect takes of a microcontroller's flash.

pub(crate) mod effects;
pub(crate) mod program;
mod report;
pub(crate) mod tests;

use anyhow::Result;

use crate::firmware::Board;
use crate::progress::Progress;
use effects::{Effects, Format};
use report::Report;

/// The options of `size`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub(crate) struct SizeOptions {
    /// Print {target: {format: {effect: bytes}}} instead of the table
    #[arg(long)]
    pub(crate) json: bool,
}

/// The smallest processor, one with a floating point unit, and one of another make.
const BOARDS: [&str; 3] = ["cortex-m0", "cortex-m4f", "rv32imc"];

/// Builds every effect in every format for each target, and prints the bytes.
pub(crate) fn run(options: &SizeOptions) -> Result<()> {
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
