//! The boards' part of `cargo xtask full`.

use tools::command;
use tools::suite::Suite;

use super::{ALL, check};

/// Adds the steps of each board: its firmware is formatted and built, and checked where an emulator
/// runs it.
pub fn run(suite: &mut Suite) {
    for device in &ALL {
        let name = device.name;
        suite.step(&format!("board: {name}, cargo fmt"), |progress| {
            let mut fmt = device.cargo(command::cargo("fmt"));
            fmt.arg("--check");
            progress.run(fmt)
        });
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
