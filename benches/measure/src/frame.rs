//! `cargo xtask frame`: a picture that a microcontroller lights pixel by pixel, and what a pixel
//! costs.

mod list;
mod output;
mod part;
mod picture;
pub mod steps;

use std::path::Path;

use anyhow::{Context, Result, bail, ensure};

use self::list::{Counts, StageList};
use self::output::Output;
use crate::boards::Rp2040;
use crate::boards::board::{self, Board};
use crate::boards::laboratory::{self, Laboratory};
use crate::boards::symbols::Symbols;
use crate::record;
use crate::size::program::Program;
use tools::progress::Progress;

/// The options of `frame`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub struct FrameOptions {
    /// Draw on this one only: cortex-m0, cortex-m3, cortex-m4f or rv32imc; may be repeated
    #[arg(long = "target", value_name = "NAME", value_parser = Board::named)]
    pub boards: Vec<&'static Board>,
    /// Write picture and counts although they differ from those in docs and benches/firmware/README.md
    #[arg(long)]
    pub bless: bool,
}

/// The firmware program.
const PROGRAM: &str = "frame";

/// Draws the picture, prints the table, and compares the counts with the record or writes them.
pub fn run(options: &FrameOptions) -> Result<()> {
    let progress = Progress::Live;
    let boards = if options.boards.is_empty() { board::ALL.iter().collect() } else { options.boards.clone() };
    let mut list = drawn(&boards, &progress)?;
    print!("{}", part::table(&list));
    if options.bless {
        list.take_missing(record::load()?);
        return record::write(&list, true, &progress);
    }
    record::check(&list)?.iter().for_each(|remark| println!("{remark}"));
    println!("picture and counts are those on record");
    Ok(())
}

/// Fails if another program draws the picture on a Cortex-M0 in clearly another number of instructions
/// than on record, and both are by the same compiler. The compiler inlines differently in a program
/// that also draws another picture.
pub(crate) fn agrees(program: &Path, instructions: u64) -> Result<()> {
    let list: StageList = record::load()?.context("there is no picture on record")?;
    let recorded = list.boards.get("cortex-m0").context("no picture of a Cortex-M0 is on record")?;
    let expected: u64 = recorded.instructions.values().sum();
    let is_same = instructions.abs_diff(expected) * 50 <= expected;
    let is_comparable = Symbols::read(program)?.compiler == recorded.compiler;
    ensure!(is_same || !is_comparable, "expected {expected} instructions, found {instructions}");
    Ok(())
}

/// Draws on the host, whose results are right by definition, and on boards. Counts the cycles of
/// the Cortex-M0.
fn drawn(boards: &[&'static Board], progress: &Progress) -> Result<StageList> {
    let host = Output::parse(&laboratory::on_the_host(PROGRAM, progress)?)?;
    let counts = boards.iter().map(|board| {
        let laboratory = Laboratory::with_program(PROGRAM, board, progress)?;
        let clock = Rp2040::for_board(board, progress)?;
        Ok((board.name.to_owned(), draw(&laboratory, &host, clock.as_ref())?))
    });
    let boards = counts.collect::<Result<_>>()?;
    Ok(StageList { boards, ..StageList::new(host) })
}

/// Draws on a board. The picture must be the host's, and the program may not contain soft-float
/// functions.
fn draw(laboratory: &Laboratory, host: &Output, clock: Option<&Rp2040>) -> Result<Counts> {
    let run =
        laboratory.run_with(PROGRAM, |lines| Output::parse(lines).map_or(0, |output| output.regions()))?;
    let output = Output::parse(&run.lines)?;
    if let Some((column, row)) = output.picture.first_difference(&host.picture) {
        bail!("not the picture of the host: they differ in column {column} of row {row}");
    }
    ensure!(output == *host, "not what the host prints: `{}`, there `{}`", output.tally, host.tally);
    let file = laboratory.program(PROGRAM);
    let program = Program::read(&file)?;
    program.has_no_float()?;
    let symbols = Symbols::read(&file)?;
    let mut counts = Counts::new(&symbols.compiler, program.bytes);
    for (stage, region) in output.stages.iter().cycle().zip(&run.regions) {
        counts.add(stage, region.instructions());
    }
    if let Some(clock) = clock {
        for (stage, cycles) in output.stages.iter().cycle().zip(clock.cycles(&file, &run)?) {
            *counts.cycles.entry(stage.clone()).or_default() += cycles;
        }
    }
    Ok(counts)
}
