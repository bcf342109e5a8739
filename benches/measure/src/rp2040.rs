//! Cycles on the core of an RP2040, a Cortex-M0+, emulated by rp2040js without wait states.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use tools::progress::Progress;
use tools::{board, command, install, project, tool};

use crate::qemu::Region;

/// Runs firmware in the emulator.
const SCRIPT: &str = "benches/measure/src/rp2040.mjs";

/// A call of a script that takes the emulator's folder as its first argument. Installs the emulator below
/// `target` if it is missing.
pub(crate) fn script(script: &str, progress: &Progress) -> Result<Command> {
    let mut node = Command::new(install::program(&tool::NODE, progress)?);
    node.arg(project::root().join(script)).arg(board::emulator(progress)?);
    Ok(node)
}

/// The name and the version, as in `rp2040js 1.4.1`.
pub(crate) fn describe() -> Result<String> {
    install::npm_version(board::RP2040JS)
}

/// Returns the cycles of each region of a program that QEMU has run. An error if it prints other lines
/// here than there, or executes other numbers of instructions in the regions.
pub(crate) fn cycles(
    program: &Path,
    lines: &str,
    regions: &[Region],
    progress: &Progress,
) -> Result<Vec<u64>> {
    let counts = project::target().join("rp2040.counts");
    let printed = command::answer(script(SCRIPT, progress)?.arg(program).arg(&counts))?;
    ensure!(printed == lines, "rp2040js does not print the lines that QEMU prints");
    let text = fs::read_to_string(&counts).context("rp2040js has counted nothing")?;
    let region = |(number, line): (usize, &str)| {
        let (instructions, cycles) = line.split_once(' ').context("not two numbers")?;
        let counted = regions.get(number).map_or(0, |region| region.values().sum());
        let instructions: u64 = instructions.parse()?;
        ensure!(counted == instructions, "region {number}: {instructions} in rp2040js, {counted} in QEMU");
        Ok(cycles.parse()?)
    };
    text.lines().enumerate().map(region).collect()
}
