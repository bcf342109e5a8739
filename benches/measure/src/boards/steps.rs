//! The firmware's part of `cargo xtask full`.

use anyhow::{Context, Result, bail, ensure};

use super::laboratory::{self, Laboratory};
use super::{Board, KERNELS, cost};
use crate::size::effects::write_programs;
use tools::command;
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::Tally;

/// Adds the steps. On the host: format, lints and the firmware's own tests. For each board: the
/// counter is exact, and the results are the host's.
pub fn run(suite: &mut Suite, boards: &[&'static Board]) {
    suite.step("firmware: cargo fmt", |progress| {
        let mut cargo = laboratory::firmware(command::cargo("fmt"));
        cargo.args(["--all", "--check"]);
        progress.run(cargo)
    });
    // Clippy comes before the host's tests, because it would wait for the folder that they are
    // compiled in.
    suite.step("firmware: cargo clippy", |progress| {
        write_programs()?;
        let mut cargo = laboratory::firmware(command::cargo("clippy"));
        cargo.args(["--workspace", "--features", "conform,effects", "--all-targets", "--", "-Dwarnings"]);
        progress.run(cargo)
    });
    suite.count("firmware: its tests on the host", |progress| {
        Ok(Tally::of_cargo_test(&progress.output(laboratory::firmware(command::cargo("test")))?))
    });
    suite.step("firmware: built for each board", |progress| {
        laboratory::build_for_all(boards, &["--release", "--bins"], progress)
    });
    for &board in boards {
        suite.step(&format!("firmware: the counter is exact on {}", board.name), |progress| {
            instrument(&Laboratory::new(board, progress)?)
        });
        suite.step(&format!("firmware: the same bits on {} as on the host", board.name), |progress| {
            results(&Laboratory::new(board, progress)?, progress)
        });
    }
}

/// Checks that the counter counts the known numbers of instructions, and that two runs give the
/// same count at every address.
fn instrument(laboratory: &Laboratory) -> Result<()> {
    let run = laboratory.run("instrument")?;
    ensure!(!run.lines.is_empty(), "the firmware has printed nothing");
    for (line, region) in run.lines.iter().zip(&run.regions) {
        let (expected, name) = line.split_once(' ').with_context(|| format!("not a region: {line}"))?;
        if expected.parse() != Ok(region.instructions()) {
            bail!("{name} counted as {} instructions, not {expected}", region.instructions());
        }
    }
    ensure!(laboratory.run("instrument")? == run, "two runs were counted differently");
    Ok(())
}

fn results(laboratory: &Laboratory, progress: &Progress) -> Result<()> {
    let host = laboratory::on_the_host(KERNELS, progress)?;
    ensure!(!host.is_empty(), "the firmware has printed nothing on the host");
    cost::measure(laboratory, KERNELS, &host, None).map(|_| ())
}
