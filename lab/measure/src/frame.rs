//! `cargo xtask frame`: a picture that a microcontroller lights pixel by pixel, and what a pixel
//! costs.

mod output;
mod part;
mod picture;
mod record;
pub mod steps;

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, bail, ensure};

use self::output::Output;
use self::picture::Picture;
use self::record::{Counts, Record};
use crate::boards::board::{self, Board};
use crate::boards::laboratory::{self, Laboratory};
use crate::boards::symbols::Symbols;
use crate::size::program::Program;
use tools::progress::Progress;
use tools::project;

/// The options of `frame`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub struct FrameOptions {
    /// Draw on this one only: cortex-m0, cortex-m3, cortex-m4f or rv32imc; may be repeated
    #[arg(long = "target", value_name = "NAME", value_parser = Board::named)]
    pub boards: Vec<&'static Board>,
    /// Write picture and counts although they differ from those in docs and lab/firmware/README.md
    #[arg(long)]
    pub bless: bool,
}

/// The firmware program.
const PROGRAM: &str = "frame";

/// Draws the picture, prints the table, and compares the counts with the record or writes it.
pub fn run(options: &FrameOptions) -> Result<()> {
    let progress = Progress::Live;
    let boards = if options.boards.is_empty() { board::ALL.iter().collect() } else { options.boards.clone() };
    let host = on_the_host(&progress)?;
    let mut record = Record::new(&host);
    for board in boards {
        let counts = draw(&Laboratory::with_program(PROGRAM, board, &progress)?, &host)?;
        record.boards.insert(board.name.to_owned(), counts);
    }
    print!("{}", part::table(&record));
    if options.bless {
        record.take_missing(Record::load().ok());
        return write(&record, &host.picture, &progress);
    }
    let remarks = compare(&record, &host.picture)?;
    remarks.iter().for_each(|remark| println!("{remark}"));
    println!("picture and counts are those recorded");
    Ok(())
}

/// What the program prints where its results are right by definition.
fn on_the_host(progress: &Progress) -> Result<Output> {
    Output::parse(&laboratory::on_the_host(PROGRAM, progress)?)
}

/// Draws on a board. The picture must be the host's, and no function may stand in for a floating
/// point unit.
fn draw(laboratory: &Laboratory, host: &Output) -> Result<Counts> {
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
    Ok(counts)
}

/// Fails where a record differs from the one that is checked in, or the picture or the table from
/// what is made of it. Returns the remarks of a comparison that has passed.
fn compare(new: &Record, picture: &Picture) -> Result<Vec<String>> {
    let old = Record::load()?;
    let (mut differences, remarks) = record::compare(&old, new);
    if Picture::read(&picture_file()).ok().as_ref() != Some(picture) {
        differences.push(format!("{} is another picture", project::shown(&picture_file())));
    }
    let readme = fs::read_to_string(readme_file()).context("cannot read lab/firmware/README.md")?;
    if part::replaced(&readme, &old)? != readme {
        differences.push("lab/firmware/README.md has another table".to_owned());
    }
    if !differences.is_empty() {
        bail!("`cargo xtask frame --bless` accepts what differs:\n    {}", differences.join("\n    "));
    }
    Ok(remarks)
}

fn write(record: &Record, picture: &Picture, progress: &Progress) -> Result<()> {
    let readme = fs::read_to_string(readme_file()).context("cannot read lab/firmware/README.md")?;
    let files = [
        (Record::file(), record.text()?.into_bytes()),
        (picture_file(), picture.png()?),
        (readme_file(), part::replaced(&readme, record)?.into_bytes()),
    ];
    for (file, content) in files {
        fs::write(&file, content).with_context(|| format!("cannot write {}", project::shown(&file)))?;
        progress.say("Written", project::shown(&file));
    }
    Ok(())
}

fn picture_file() -> PathBuf {
    project::root().join("docs/frame.png")
}

fn readme_file() -> PathBuf {
    project::root().join("lab/firmware/README.md")
}
