//! The conformance vectors' part of `cargo xtask test`.

use anyhow::ensure;

use super::{Target, target};
use crate::boards::Board;
use tools::suite::Suite;
use tools::wasm::Profile;

/// Adds a step for each target. Without `full`, this machine is left out: the golden test of `cargo test`
/// checks the vectors there.
pub fn run(suite: &mut Suite, boards: &[&'static Board], full: bool) {
    suite.step("conformance: built for each board", |progress| target::build_for_boards(boards, progress));
    let profile = if full { Profile::Release } else { Profile::Quick };
    let left_out = if full { &[][..] } else { &[Target::Debug, Target::Release, Target::Std] };
    for target in Target::on(boards, profile).into_iter().filter(|target| !left_out.contains(target)) {
        suite.step(&format!("conformance: the same bits on {}", target.name()), |progress| {
            let report = target.check(progress)?;
            ensure!(report.passed, "{}\n{}", report.count, report.told);
            Ok(())
        });
    }
}
