//! Calls of the laboratory.

use std::ffi::OsString;
use std::process::{Command, ExitCode};

use anyhow::{Context, Result};

use tools::command;
use tools::progress::Progress;

/// The commands of the laboratory, each with the package that has it, and a sentence for the help.
pub(crate) const COMMANDS: [(&str, &str, &str); 12] = [
    ("board", LAB, "Build the firmware of a board with a display: rp2040, stm32f411 or esp32c3"),
    ("conform", LAB, "Compare the results of every model, bit by bit, with the conformance vectors"),
    ("effects", LAB, "Write what each effect costs: instructions a pixel and bytes of flash"),
    ("firmware", LAB, "Count what the kernels cost on microcontrollers, in QEMU"),
    ("frame", LAB, "Draw a picture on microcontrollers, in QEMU, and count the instructions of a pixel"),
    ("measure", LAB, "Write the price list of accuracy: errors, and costs on every target"),
    ("mutants", "luminaire-mutants", "Test the tests: list the changes of the kernel that no test notices"),
    ("pick", LAB, "Count the prices by which `luminaire pick` chooses an evaluation, in QEMU"),
    ("pictures", LAB, "Take the pictures of the demo for the documents again"),
    ("renderers", LAB, "Draw the pictures of renderers that are not the project's"),
    ("rivals", LAB, "Time frames of the demo and of three.js without a GPU, in one run"),
    ("size", LAB, "Count the bytes of flash that each effect takes on microcontrollers"),
];

const LAB: &str = "lab";

/// Runs a command of the laboratory, with its options.
pub(crate) fn run(words: &[OsString]) -> Result<ExitCode> {
    let name = words.first().map(|word| word.to_string_lossy()).unwrap_or_default();
    let command = COMMANDS.iter().find(|(command, ..)| *command == name);
    let names = || COMMANDS.map(|(name, ..)| name).join(", ");
    let (_, package, _) =
        command.with_context(|| format!("command = \"{name}\": expected demo, test, full, {}", names()))?;
    let arguments = if *package == LAB { words } else { &words[1..] };
    let status = program(package).args(arguments).status().context("cannot start cargo")?;
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Builds the laboratory's program.
pub(crate) fn build(progress: &Progress) -> Result<()> {
    let mut cargo = command::cargo("build");
    cargo.args(["--package", LAB]);
    progress.run(cargo)
}

/// A call of the laboratory's program, which cargo builds if need be.
pub(crate) fn steps(arguments: &[&str]) -> Command {
    let mut lab = program(LAB);
    lab.args(arguments);
    lab
}

fn program(package: &str) -> Command {
    let mut cargo = command::cargo("run");
    cargo.args(["--quiet", "--package", package, "--"]);
    cargo
}
