//! Calls of the laboratory.

use std::ffi::OsString;
use std::process::{Command, ExitCode};

use anyhow::{Context, Result};

use tools::command;
use tools::progress::Progress;

/// Runs a command of the laboratory, with its options.
pub(crate) fn run(words: &[OsString]) -> Result<ExitCode> {
    let status = program().args(words).status().context("cannot start cargo")?;
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Builds the laboratory's program.
pub(crate) fn build(progress: &Progress) -> Result<()> {
    let mut cargo = command::cargo("build");
    cargo.args(["--package", "lab"]);
    progress.run(cargo)
}

/// A call of the laboratory's program, which cargo builds if need be. Its arguments are still to be
/// given.
pub(crate) fn program() -> Command {
    let mut cargo = command::cargo("run");
    cargo.args(["--quiet", "--package", "lab", "--"]);
    cargo
}
