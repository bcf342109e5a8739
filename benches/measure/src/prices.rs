//! `cargo xtask measure`: the price list of accuracy.

mod clocked;
mod figures;
mod frontier;
mod ladder;
mod list;
mod page;
mod plot;
mod summary;
mod target;

use anyhow::{Context, Result};

use self::clocked::{Measured, Times};
use self::list::{Cost, PriceList, Row, TargetMeta};
use crate::boards::{self, Rp2040};
use crate::record;
use tools::progress::Progress;

pub use target::Target;

/// The options of `measure`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub struct MeasureOptions {
    /// Measure the costs on this one only: host, wasm, wasm-simd or a processor; may be repeated
    #[arg(long = "target", value_name = "NAME", value_parser = Target::named)]
    pub targets: Vec<Target>,
    /// Compare errors and instructions with the list instead, and write nothing
    #[arg(long)]
    pub check: bool,
    /// Write the list also where errors or instructions differ from it
    #[arg(long, conflicts_with = "check")]
    pub bless: bool,
}

/// Measures, compares with the list, and writes the list and the documents made from it.
pub fn run(options: &MeasureOptions) -> Result<()> {
    let progress = Progress::Live;
    if options.check {
        for remark in check(&options.targets, &progress)? {
            println!("{remark}");
        }
        println!("errors and counts are those of the list");
        return Ok(());
    }
    let targets = if options.targets.is_empty() { Target::all() } else { options.targets.clone() };
    record::write(&measure(&targets, &progress)?, options.bless, &progress)
}

/// Compares errors and counts with the list, and the documents with those that the list would give.
/// Times are not compared. Returns remarks if the comparison has passed.
pub fn check(targets: &[Target], progress: &Progress) -> Result<Vec<String>> {
    let chosen = |target: &Target| targets.is_empty() || targets.contains(target);
    let targets: Vec<_> = Target::counted().into_iter().filter(chosen).collect();
    record::check(&measure(&targets, progress)?)
}

/// Measures the errors, and the costs on these targets. The costs on other
/// targets are those on record.
fn measure(targets: &[Target], progress: &Progress) -> Result<PriceList> {
    let mut list = with_errors(progress)?;
    if let Some(old) = record::load::<PriceList>()? {
        list.meta.targets.clone_from(&old.meta.targets);
        for row in &mut list.rows {
            if let Some(old) = old.row(&row.name()) {
                (row.cost, row.bytes) = (old.cost.clone(), old.bytes.clone());
            }
        }
    }
    let timed = targets.iter().any(|target| !matches!(target, Target::Board(_)));
    let host = if timed { Some(clocked::host(progress)?) } else { None };
    let expected = if !targets.iter().any(|target| matches!(target, Target::Board(_))) {
        Vec::new()
    } else {
        boards::expected(progress)?
    };
    for target in targets {
        for row in &mut list.rows {
            row.cost.remove(target.name());
            row.bytes.remove(target.name());
        }
        let mut meta = match target {
            Target::Board(board) => {
                let clock = Rp2040::for_board(board, progress)?;
                count(&mut list, board, &expected, clock.as_ref(), progress)?
            }
            Target::Browser { simd } => {
                let (host, _) = host.as_ref().context("the host is timed first")?;
                let (times, meta) = clocked::browser(*simd, host, progress)?;
                note(&mut list, target.name(), times)?;
                meta
            }
            Target::Host => {
                let (times, meta) = host.clone().context("the host is timed first")?;
                note(&mut list, target.name(), times)?;
                meta
            }
        };
        meta.measured = jiff::Timestamp::now().strftime("%F").to_string();
        list.meta.targets.insert(target.name().to_owned(), meta);
        compare_with_powf(&mut list, target)?;
    }
    Ok(list)
}

/// The rows, with their errors.
fn with_errors(progress: &Progress) -> Result<PriceList> {
    let mut list = PriceList { ladder: clocked::ladder(progress)?, ..PriceList::default() };
    for Measured { kernel, cone } in clocked::accuracy(progress)? {
        if let Ok(row) = list.row_mut(&kernel.name()) {
            row.narrower.push(cone);
            continue;
        }
        if list.rows.is_empty() {
            list.meta.half_angle = cone.half_angle;
        }
        list.rows.push(Row {
            kernel: kernel.kernel,
            stage: kernel.stage,
            format: kernel.format,
            error: cone.error,
            narrower: Vec::new(),
            cost: Default::default(),
            bytes: Default::default(),
        });
    }
    Ok(list)
}

/// Counts on a board and enters the costs into the list. Returns what the costs depend on.
fn count(
    list: &mut PriceList,
    board: &'static boards::Board,
    expected: &[String],
    clock: Option<&Rp2040>,
    progress: &Progress,
) -> Result<TargetMeta> {
    let costs = boards::costs(board, expected, clock, progress)?;
    for cost in costs.kernels {
        let row = list.row_mut(&cost.name())?;
        let instructions = thousandths(cost.instructions);
        let counted =
            Cost::Counted { instructions, cycles: cost.cycles.map(thousandths), ratio_to_powf: 0.0 };
        row.cost.insert(board.name.to_owned(), counted);
        row.bytes.insert(board.name.to_owned(), cost.bytes);
    }
    Ok(TargetMeta {
        compiler: costs.compiler,
        flags: "opt-level=3 lto=fat codegen-units=1".to_owned(),
        runs_on: costs.emulator,
        reference: Target::Board(board).reference().to_owned(),
        measured: String::new(),
    })
}

fn note(list: &mut PriceList, target: &str, times: Vec<Times>) -> Result<()> {
    for times in times {
        let [lower, ns, upper] = times.quartiles;
        let timed = Cost::Timed { ns, ns_quartiles: [lower, upper], ratio_to_powf: 0.0 };
        list.row_mut(&times.kernel.name())?.cost.insert(target.to_owned(), timed);
    }
    Ok(())
}

/// Enters for each kernel how many of its calls cost as much as one call of the power function.
fn compare_with_powf(list: &mut PriceList, target: &Target) -> Result<()> {
    let reference = list.row(target.reference()).and_then(|row| row.cost.get(target.name()));
    let reference = reference.context("the power function has not been measured")?.amount();
    for cost in list.rows.iter_mut().filter_map(|row| row.cost.get_mut(target.name())) {
        *cost.ratio() = thousandths(reference / cost.amount());
    }
    Ok(())
}

fn thousandths(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}
