//! The conformance vectors' part of `cargo xtask test`.

use anyhow::ensure;

use super::{Target, target};
use tools::suite::Suite;

/// Adds a step for each target. Without `full`, this machine is left out: the golden test of `cargo test`
/// checks the vectors there.
pub fn run(suite: &mut Suite, full: bool) {
    let targets = if full { Target::all() } else { Target::quick() };
    let boards: Vec<_> = targets.iter().filter_map(|target| target.board()).collect();
    suite.step("conformance: built for each board", |progress| target::build_for_boards(&boards, progress));
    for target in targets {
        suite.step(&format!("conformance: the same bits on {}", target.name()), |progress| {
            let report = target.check(progress)?;
            ensure!(report.passed, "{}\n{}", report.count, report.told);
            Ok(())
        });
    }
}
