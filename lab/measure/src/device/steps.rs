//! The boards' part of `cargo xtask full`.

use tools::board::in_folder;
use tools::suite::Suite;
use tools::{command, tally};

use super::{ALL, check};

/// The packages that are not the firmware of a board: what the boards share, and the firmware to
/// copy.
const OTHERS: [&str; 2] = ["panel", "template"];

/// Adds the steps of each board: its firmware is formatted and built, and checked where an emulator
/// runs it.
pub fn run(suite: &mut Suite) {
    for name in OTHERS.into_iter().chain(ALL.iter().map(|device| device.name)) {
        suite.step(&format!("board: {name}, cargo fmt"), |progress| {
            let mut fmt = in_folder(name, command::cargo("fmt"));
            fmt.arg("--check");
            progress.run(fmt)
        });
    }
    suite.count("board: panel, cargo test", |progress| {
        tally::cargo_test(in_folder("panel", command::cargo("test")), progress)
    });
    for device in &ALL {
        let name = device.name;
        if device.is_run {
            suite.remarked(&format!("board: {name} sends the host's pixels to its display"), |progress| {
                check::check(&device.build(progress)?, progress)
            });
        } else {
            suite.step(&format!("board: {name} is built, not run"), |progress| {
                device.build(progress).map(|_| ())
            });
        }
    }
}
