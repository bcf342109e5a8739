//! The effects' part of `cargo xtask test`.

use super::check;
use super::prices::STANDS;
use crate::command;
use crate::firmware::laboratory;
use crate::suite::Suite;

/// Adds the steps: lints of what counts, and for each board that the prices are those recorded.
pub(crate) fn run(suite: &mut Suite) {
    suite.step("effects: cargo clippy of what counts them", |progress| {
        let mut cargo = laboratory::firmware(command::cargo("clippy"));
        cargo.args(["--package", "luminaire-firmware", "--features", "effects", "--all-targets"]);
        cargo.args(["--", "-Dwarnings"]);
        progress.run(cargo)
    });
    for stand in &STANDS {
        let name = format!("effects: instructions and bytes are those recorded on {}", stand.board);
        suite.step(&name, |progress| {
            check(stand, progress)?.iter().for_each(|remark| progress.say("Compared", remark));
            Ok(())
        });
    }
}
