//! The laboratory: measures the kernel's errors, costs and bytes on every target, and compares them
//! with the figures on record.

pub mod c;
pub mod conform;
mod counted;
pub mod device;
mod documents;
mod drawn;
mod effects;
mod frame;
mod ladder;
mod pictures;
mod plot;
pub mod program;
mod proof;
mod public;
mod qemu;
mod record;
pub mod rivals;
mod rp2040;
mod stack;
pub mod steps;
mod target;
mod timed;
mod worst;

use anyhow::{Context, Result, bail, ensure};
use tools::progress::Progress;

use record::Record;
pub use target::{BOARDS, Board, Target};

/// The options of `measure`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub struct MeasureOptions {
    /// Measure this only: errors, or the costs on host, wasm, wasm-simd or a processor; may be repeated
    #[arg(long = "target", value_name = "NAME", value_parser = Target::named)]
    pub targets: Vec<Target>,
    /// Compare errors and counts with those on record, and write nothing
    #[arg(long)]
    pub check: bool,
    /// Write the figures also where errors or counts differ from those on record
    #[arg(long, conflicts_with = "check")]
    pub bless: bool,
    /// Split the instructions of one kernel, such as lit.fx16, by function instead
    #[arg(long, value_name = "KERNEL", conflicts_with_all = ["check", "bless"])]
    pub by_symbol: Option<String>,
}

/// Measures, compares with the record, and writes the record and the documents made from it.
pub fn run(options: &MeasureOptions) -> Result<()> {
    let progress = Progress::Live;
    let targets = if options.targets.is_empty() { Target::all() } else { options.targets.clone() };
    if let Some(kernel) = &options.by_symbol {
        // Without a name, every processor with kernels in Rust.
        let isnt_named = options.targets.is_empty();
        return targets.into_iter().try_for_each(|target| match target {
            Target::Board(board) => by_symbol(kernel, board, &progress),
            _ if isnt_named => Ok(()),
            _ => bail!("target = {}: expected a processor with kernels in Rust", target.name()),
        });
    }
    let mut now = Record::default();
    for target in targets {
        // Times are not compared.
        if options.check && matches!(target, Target::Host | Target::Browser { .. }) {
            continue;
        }
        now.0.extend(on(target, options.check, &progress)?.0);
    }
    now.keep_most(&Record::load()?);
    if options.check {
        documents::check(&now)?.iter().for_each(|remark| println!("{remark}"));
        println!("errors and counts are those on record");
        return Ok(());
    }
    documents::write(now, options.bless, &progress)
}

/// Measures on a target.
fn on(target: Target, check: bool, progress: &Progress) -> Result<Record> {
    match target {
        Target::Errors => timed::errors(progress),
        Target::Host => timed::host(progress),
        Target::Browser { simd } => timed::browser(simd, progress),
        Target::Board(board) => {
            let mut group = effects::counted(board, progress)?;
            c::add(board, &mut group, progress)?;
            stack::add(board, &mut group, progress)?;
            worst::add(board, &mut group, progress)?;
            drawn::add(board, &mut group, progress)?;
            let picture = frame::draw(board, &mut group, check, progress)?;
            let groups = [("picture", picture), (board.name, group)];
            Ok(Record(groups.map(|(name, group)| (name.to_owned(), group)).into()))
        }
        Target::OfC(board) => Ok(Record([(board.name.to_owned(), c::counted(board, progress)?)].into())),
    }
}

/// Prints the instructions of a kernel by function.
fn by_symbol(kernel: &str, board: &'static Board, progress: &Progress) -> Result<()> {
    let costs = effects::costs(board, progress)?;
    let found = costs.iter().find(|cost| cost.name == kernel);
    let names = || costs.iter().map(|cost| cost.name.as_str()).collect::<Vec<_>>().join(", ");
    let cost = found.with_context(|| format!("kernel = {kernel}: expected one of {}", names()))?;
    ensure!(!cost.split.is_empty(), "{kernel} has no instructions");
    println!("{}: {}", board.name, cost.by_symbol());
    Ok(())
}
