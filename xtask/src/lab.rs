//! Calls of the laboratory.

use std::ffi::OsString;
use std::process::{Command, ExitCode};

use anyhow::{Context, Result, ensure};

use tools::command;
use tools::progress::Progress;

/// The commands of the laboratory, with a sentence for the help.
pub(crate) const COMMANDS: [(&str, &str); 10] = [
    ("board", "Build the firmware of a board with a display: rp2040"),
    ("conform", "Compare the results of every model, bit by bit, with the conformance vectors"),
    ("effects", "Write what each effect costs: instructions a pixel and bytes of flash"),
    ("firmware", "Count what the kernels cost on microcontrollers, in QEMU"),
    ("frame", "Draw a picture on microcontrollers, in QEMU, and count the instructions of a pixel"),
    ("measure", "Write the price list of accuracy: errors, and costs on every target"),
    ("pick", "Count the prices by which `luminaire pick` chooses an evaluation, in QEMU"),
    ("pictures", "Take the pictures of the demo for the documents again"),
    ("renderers", "Draw the pictures of renderers that are not the project's"),
    ("rivals", "Time frames of the demo and of three.js without a GPU, in one run"),
];

/// Runs a command of the laboratory, with its options.
pub(crate) fn run(words: &[OsString]) -> Result<ExitCode> {
    let name = words.first().map(|word| word.to_string_lossy()).unwrap_or_default();
    let names = COMMANDS.map(|(name, _)| name);
    ensure!(names.contains(&&*name), "command = \"{name}\": expected demo, test, full, {}", names.join(", "));
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
