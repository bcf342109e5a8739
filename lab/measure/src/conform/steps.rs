//! The conformance vectors' part of `cargo xtask test`.

use anyhow::ensure;

use super::{Target, target};
use crate::boards::Board;
use tools::suite::Suite;

/// Adds a step for each target.
pub fn run(suite: &mut Suite, boards: &[&'static Board]) {
    suite.step("conformance: built for each board", |progress| target::build_for_boards(boards, progress));
    for target in Target::on(boards) {
        suite.step(&format!("conformance: the same bits on {}", target.name()), |progress| {
            let report = target.check(progress)?;
            ensure!(report.passed, "{}\n{}", report.count, report.told);
            Ok(())
        });
    }
}
