//! The conformance vectors' part of `cargo xtask test`.

use anyhow::ensure;

use super::{Target, target};
use crate::suite::Suite;

/// Adds a step for each target.
pub(crate) fn run(suite: &mut Suite) {
    suite.step("conformance: built for all boards", target::build_for_all_boards);
    for target in Target::all() {
        suite.step(&format!("conformance: the same bits on {}", target.name()), |progress| {
            let report = target.check(progress)?;
            ensure!(report.passed, "{}\n{}", report.count, report.told);
            Ok(())
        });
    }
}
