//! The targets on which the conformance vectors are checked.

use std::env::consts::EXE_SUFFIX;
use std::fs::File;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, ensure};

use super::page;
use super::vectors::{self, Vectors};
use crate::boards::emulator::Emulator;
use crate::boards::{Board, board, laboratory};
use tools::command;
use tools::progress::Progress;
use tools::project;

/// The boards whose 256 kB of flash hold all models at once only if the models are compiled for
/// size.
const SMALL: [&str; 2] = ["cortex-m0", "cortex-m3"];

/// A way to build and run the check.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Target {
    /// This machine, without optimisation and with overflow checks.
    Debug,
    /// This machine, optimised and without overflow checks: an overflow would wrap unnoticed.
    Release,
    /// This machine, optimised, with the square root of `std`.
    Std,
    /// WebAssembly in a browser.
    Browser,
    /// A microcontroller, in QEMU.
    Board(&'static Board),
}

/// The result of a check.
#[derive(Debug, PartialEq)]
pub(crate) struct Report {
    /// The first cases that differ, each on a line.
    pub(crate) told: String,
    /// The counts, as in `123 cases, 0 differ`.
    pub(crate) count: String,
    /// Whether all cases of the file were checked and none differs.
    pub(crate) passed: bool,
}

impl Target {
    /// All targets, the quickest to check first.
    pub(crate) fn all() -> Vec<Self> {
        let boards = board::ALL.iter().map(Self::Board);
        let others = [Self::Debug, Self::Release, Self::Std, Self::Browser];
        others.into_iter().chain(boards).collect()
    }

    /// The targets of a quick test: a browser, and the smallest board.
    pub(super) fn quick() -> Vec<Self> {
        vec![Self::Browser, Self::Board(&board::ALL[0])]
    }

    /// The board, if it is one.
    pub(super) fn board(self) -> Option<&'static Board> {
        match self {
            Self::Board(board) => Some(board),
            _ => None,
        }
    }

    /// The name in reports.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Debug => "host, debug",
            Self::Release => "host, release",
            Self::Std => "host, release with std",
            Self::Browser => page::TARGET,
            Self::Board(board) => board.target,
        }
    }

    /// The targets of a name on the command line: `host`, `wasm` or the name of a board.
    pub(crate) fn named(name: &str) -> Result<Vec<Self>, String> {
        match name {
            "host" => Ok(vec![Self::Debug, Self::Release, Self::Std]),
            "wasm" => Ok(vec![Self::Browser]),
            _ => match Board::named(name) {
                Ok(board) => Ok(vec![Self::Board(board)]),
                Err(refused) => Err(format!("{refused}, host and wasm")),
            },
        }
    }

    /// Builds the check for the target and runs it there.
    pub(crate) fn check(self, progress: &Progress) -> Result<Report> {
        let cases = Vectors::load()?.cases();
        let output = match self {
            Self::Debug => on_the_host(&[], "debug", progress),
            Self::Release => on_the_host(&["--release"], "release", progress),
            Self::Std => on_the_host(&["--release", "--features", "std"], "release", progress),
            Self::Browser => page::check(progress),
            Self::Board(board) => on_a_board(board, progress),
        }?;
        Report::read(&output, cases)
    }
}

impl Report {
    /// Reads the output of a check. The file that was checked has `cases` cases.
    fn read(output: &str, cases: usize) -> Result<Self> {
        let output = output.trim_end();
        let (told, count) = output.rsplit_once('\n').unwrap_or(("", output));
        ensure!(count.contains(" cases, "), "the check did not come to its end: {output}");
        let told = if told.is_empty() { String::new() } else { format!("{told}\n") };
        let passed = count == format!("{cases} cases, 0 differ");
        Ok(Self { told, count: count.to_owned(), passed })
    }
}

/// Builds the program `conform` for this machine.
pub(super) fn host(options: &[&str], profile: &str, progress: &Progress) -> Result<PathBuf> {
    let mut build = command::cargo("build");
    build.args(["--package", "luminaire-conform", "--bin", "conform"]).args(options);
    progress.run(build)?;
    Ok(project::target().join(profile).join(format!("conform{EXE_SUFFIX}")))
}

fn on_the_host(options: &[&str], profile: &str, progress: &Progress) -> Result<String> {
    let program = host(options, profile, progress)?;
    let file = File::open(vectors::path()).context("cannot open the conformance vectors")?;
    let output = Command::new(program).arg("check").stdin(file).output().context("cannot run the check")?;
    // The exit code is ignored: it is a failure if cases differ, and the report says so.
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

fn on_a_board(board: &'static Board, progress: &Progress) -> Result<String> {
    let emulator = Emulator::find(board, progress)?;
    let profile = profile(board);
    let toolchain = laboratory::build(board, &arguments(profile), progress)?;
    emulator.run_in(&vectors::folder(), &toolchain.artifacts(profile).join("conform"))
}

/// Builds the check for each board in advance.
pub(super) fn build_for_boards(boards: &[&Board], progress: &Progress) -> Result<()> {
    for group in boards.chunk_by(|one, next| profile(one) == profile(next)) {
        laboratory::build_for_all(group, &arguments(profile(group[0])), progress)?;
    }
    Ok(())
}

/// Arguments of cargo for a profile.
fn arguments(profile: &str) -> [&str; 6] {
    ["--profile", profile, "--bin", "conform", "--features", "conform"]
}

/// The profile that the check is compiled with for a board.
fn profile(board: &Board) -> &'static str {
    if SMALL.contains(&board.name) { "size" } else { "release" }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_counts_its_cases() {
        let passed = Report::read("12 cases, 0 differ\n", 12).unwrap();
        assert_eq!((passed.told.as_str(), passed.passed), ("", true));
        assert!(!Report::read("11 cases, 0 differ\n", 12).unwrap().passed);
        let failed = Report::read("line 9: 00 -> 01, found 02\n12 cases, 1 differ\n", 12).unwrap();
        assert_eq!((failed.told.as_str(), failed.passed), ("line 9: 00 -> 01, found 02\n", false));
        assert!(Report::read("panicked", 12).is_err());
    }

    #[test]
    fn a_target_is_found_by_its_name_or_the_names_are_told() {
        assert_eq!(Target::named("host").unwrap().len(), 3);
        assert_eq!(Target::named("cortex-m0").unwrap()[0].name(), "thumbv6m-none-eabi");
        let refused = Target::named("cortex-m1").unwrap_err();
        assert!(refused.contains("wasm") && refused.contains("rv32imc"), "{refused}");
    }
}
