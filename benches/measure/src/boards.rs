//! `cargo xtask firmware`: what the kernels cost on microcontrollers, in exact numbers of
//! instructions.

pub(crate) mod board;
pub(crate) mod cost;
mod counts;
pub(crate) mod emulator;

pub(crate) mod laboratory;
mod package;
mod report;
mod rp2040;
pub mod steps;
pub(crate) mod symbols;

use anyhow::{Result, bail};

use tools::progress::Progress;

pub use board::{ALL as BOARDS, Board};
pub(crate) use cost::Costs;
use laboratory::Laboratory;
pub(crate) use rp2040::Rp2040;

/// The options of `firmware`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub struct FirmwareOptions {
    /// Count on this one only: cortex-m0, cortex-m3, cortex-m4f or rv32imc; may be repeated
    #[arg(long = "target", value_name = "NAME", value_parser = Board::named)]
    pub boards: Vec<&'static Board>,
    /// Split one kernel, such as lit.fx16, by function instead of printing the table
    #[arg(long, value_name = "KERNEL")]
    pub by_symbol: Option<String>,
}

/// The program that runs the kernels.
const KERNELS: &str = "cost";
/// The program that runs the effects.
const EFFECTS: &str = "effects";

/// Returns the lines that the program of the kernels must print: those that it prints on the host.
pub(crate) fn expected(progress: &Progress) -> Result<Vec<String>> {
    laboratory::on_the_host(KERNELS, progress)
}

/// What every kernel costs on a board. An error if a result differs from the expected one. Counts
/// cycles with an emulator that does.
pub(crate) fn costs(
    board: &'static Board,
    expected: &[String],
    clock: Option<&Rp2040>,
    progress: &Progress,
) -> Result<Costs> {
    cost::measure(&Laboratory::new(board, progress)?, KERNELS, expected, clock)
}

/// What every effect costs on a board, in the number format that a feature selects and in a profile
/// of the firmware.
pub(crate) fn effects(
    board: &'static Board,
    feature: &str,
    profile: &str,
    clock: Option<&Rp2040>,
    progress: &Progress,
) -> Result<Costs> {
    let expected = laboratory::on_the_host_with_feature(EFFECTS, feature, progress)?;
    let laboratory = Laboratory::with_feature(EFFECTS, feature, profile, board, progress)?;
    cost::measure(&laboratory, EFFECTS, &expected, clock)
}

/// Counts the instructions on each board and prints the table.
pub fn run(options: &FirmwareOptions) -> Result<()> {
    let progress = Progress::Live;
    let boards = if options.boards.is_empty() { board::ALL.iter().collect() } else { options.boards.clone() };
    let expected = expected(&progress)?;
    let mut report = report::Report { boards: Vec::new() };
    for board in boards {
        report.boards.push((board, costs(board, &expected, None, &progress)?));
    }
    let Some(wanted) = &options.by_symbol else {
        print!("{report}");
        return Ok(());
    };
    for (board, costs) in &report.boards {
        let Some(cost) = costs.kernels.iter().find(|cost| cost.name() == *wanted) else {
            let names: Vec<_> = costs.kernels.iter().map(cost::Cost::name).collect();
            bail!("there is no kernel {wanted}; there are {}", names.join(", "));
        };
        println!("{}", report::by_symbol(board, cost));
    }
    Ok(())
}
