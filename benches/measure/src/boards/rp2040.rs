//! Cycles on the core of an RP2040, a Cortex-M0+, emulated by rp2040js without wait states.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use tools::progress::Progress;
use tools::{board, command, install, project};

use super::board::Board;
use super::laboratory::Run;

/// Runs firmware in the emulator.
const SCRIPT: &str = "benches/measure/src/boards/rp2040.mjs";

/// The emulator.
#[derive(Debug)]
pub(crate) struct Rp2040 {
    node: PathBuf,
    library: PathBuf,
}

impl Rp2040 {
    /// Finds the emulator for the firmware of a board. `None` if the core does not run this firmware.
    pub(crate) fn for_board(board: &Board, progress: &Progress) -> Result<Option<Self>> {
        if board.name == "cortex-m0" { Self::find(progress).map(Some) } else { Ok(None) }
    }

    /// Finds the emulator, or installs it below `target`.
    pub(crate) fn find(progress: &Progress) -> Result<Self> {
        Ok(Self { node: install::node(progress)?, library: board::emulator(progress)? })
    }

    /// A call of a script that takes the emulator's folder as its first argument.
    pub(crate) fn script(&self, script: &str) -> Command {
        let mut node = Command::new(&self.node);
        node.arg(project::root().join(script)).arg(&self.library);
        node
    }

    /// The name and the version, as in `rp2040js 1.4.1`.
    pub(crate) fn describe() -> Result<String> {
        install::npm_version(board::RP2040JS)
    }

    /// Returns the cycles of each region of a program that QEMU has run. An error if it prints other
    /// lines here, or executes other numbers of instructions.
    pub(crate) fn cycles(&self, firmware: &Path, qemu: &Run) -> Result<Vec<u64>> {
        let counts = project::target().join("rp2040.counts");
        let printed = command::answer(self.script(SCRIPT).arg(firmware).arg(&counts))?;
        ensure!(printed.lines().eq(&qemu.lines), "rp2040js does not print the lines that QEMU prints");
        let text = fs::read_to_string(&counts).context("rp2040js has counted nothing")?;
        let regions = parse(&text)?;
        ensure!(regions.len() == qemu.regions.len(), "{} regions in rp2040js", regions.len());
        for (number, (region, [instructions, _])) in qemu.regions.iter().zip(&regions).enumerate() {
            let counted = region.instructions();
            ensure!(
                counted == *instructions,
                "region {number}: {instructions} instructions in rp2040js, {counted} in QEMU"
            );
        }
        Ok(regions.into_iter().map(|[_, cycles]| cycles).collect())
    }
}

/// Parses the instructions and the cycles of each region.
fn parse(text: &str) -> Result<Vec<[u64; 2]>> {
    let line = |line: &str| {
        let (instructions, cycles) = line.split_once(' ')?;
        Some([instructions.parse().ok()?, cycles.parse().ok()?])
    };
    text.lines().map(|text| line(text).with_context(|| format!("not two numbers: {text}"))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_line_has_instructions_and_cycles() {
        assert_eq!(parse("201 300\n0 0\n").unwrap(), [[201, 300], [0, 0]]);
        for broken in ["201", "201 x", "201 300 4"] {
            assert!(parse(broken).is_err(), "{broken}");
        }
    }
}
