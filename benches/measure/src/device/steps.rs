//! The board's part of `cargo xtask full`.

use tools::board::{RP2040, in_folder};
use tools::suite::Suite;
use tools::{command, tally};

use super::{build, check};

/// Adds the steps: the packages are formatted, and the firmware is built and checked in an emulator.
pub fn run(suite: &mut Suite) {
    for name in ["panel", "template", RP2040] {
        suite.step(&format!("board: {name}, cargo fmt"), |progress| {
            let mut fmt = in_folder(name, command::cargo("fmt"));
            fmt.arg("--check");
            progress.run(fmt)
        });
    }
    suite.count("board: panel, cargo test", |progress| {
        tally::cargo_test(in_folder("panel", command::cargo("test")), progress)
    });
    suite.remarked("board: rp2040 sends the host's pixels to its display", |progress| {
        check::check(&build(progress)?, progress)
    });
}
