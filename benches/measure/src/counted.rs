//! The counts of programs that firmware runs on boards: instructions, cycles and bytes of code.

use std::collections::BTreeMap;
use std::env::consts::EXE_SUFFIX;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use tools::progress::Progress;
use tools::toolchain::Toolchain;
use tools::{command, project};

use crate::program::{Program, Split};
use crate::qemu::{Qemu, Region, prints_the_same};
use crate::record::{Group, Line};
use crate::rp2040;
use crate::target::Board;

/// The folder of the firmware.
pub(crate) const FIRMWARE: &str = "benches/firmware";
/// The profile of programs that are optimised for speed.
const RELEASE: &str = "release";
/// The profile of programs that are optimised for size.
pub(crate) const SIZE: &str = "size";

/// The kernel that does nothing, which runs before each other one over the same inputs.
const EMPTY: &str = "empty.";

/// A program of the firmware, with further options of cargo, such as features.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Firmware<'a> {
    pub(crate) name: &'a str,
    pub(crate) options: &'a [&'a str],
    pub(crate) profile: &'a str,
}

/// What a program printed on a board, and what was counted of it.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) text: String,
    pub(crate) regions: Vec<Region>,
    pub(crate) file: PathBuf,
    /// The compiler, the emulator and the board.
    pub(crate) about: Vec<(&'static str, String)>,
}

/// What a kernel costs, minus the empty loop over the same inputs.
#[derive(Debug)]
pub(crate) struct Cost {
    pub(crate) name: String,
    /// Instructions of an average call.
    pub(crate) instructions: f64,
    /// Bytes of code of all functions that the kernel calls. A function that several kernels call
    /// counts for each of them, although the program holds it once.
    pub(crate) bytes: u64,
    /// Cycles of an average call on an RP2040, if they were counted.
    pub(crate) cycles: Option<f64>,
    /// Instructions of an average call by function and its bytes, including the loop around the call.
    pub(crate) split: BTreeMap<(String, u64), f64>,
}

impl<'a> Firmware<'a> {
    /// A program of the firmware, in a profile, with a feature.
    pub(crate) fn new(name: &'a str, options: &'a [&'a str]) -> Self {
        Self { name, options, profile: RELEASE }
    }

    /// Returns what the program prints on the host. The results of the host are right by definition.
    pub(crate) fn on_the_host(&self, progress: &Progress) -> Result<String> {
        let mut build = command::cargo(["build", "--release", "--bin", self.name]);
        build.args(self.options).current_dir(project::root().join(FIRMWARE));
        progress.run(build)?;
        let program = project::target().join("release").join(format!("{}{EXE_SUFFIX}", self.name));
        command::answer(&mut Command::new(program))
    }

    /// Builds the program for a board. Returns its file.
    pub(crate) fn build(&self, board: &'static Board, progress: &Progress) -> Result<PathBuf> {
        let options = [&["--profile", self.profile, "--bin", self.name], self.options].concat();
        let toolchain = build(board, &options, progress)?;
        Ok(toolchain.artifacts(self.profile).join(self.name))
    }

    /// Runs the program on a board with the counter. It must print what it prints on the host.
    pub(crate) fn run(&self, board: &'static Board, progress: &Progress) -> Result<Run> {
        let host = self.on_the_host(progress)?;
        let (qemu, file) = (Qemu::find(board, progress)?, self.build(board, progress)?);
        let (text, regions) = qemu.count(&file, progress)?;
        prints_the_same(board, &text, &host)?;
        let about = vec![("compiler", Program::read(&file)?.compiler), ("runs_on", qemu.describe())];
        Ok(Run { text, regions, file, about })
    }

    /// What each kernel of the program costs on a board, and what the costs depend on. Counts cycles, too,
    /// where an emulator does.
    pub(crate) fn costs(&self, board: &'static Board, progress: &Progress) -> Result<(Vec<Cost>, Run)> {
        let mut run = self.run(board, progress)?;
        let cycles = run.cycles(board, progress)?;
        let (lines, program) = (Line::all(&run.text)?, Program::read(&run.file)?);
        let [calls, lines @ ..] = &lines[..] else { bail!("{} has printed nothing", self.name) };
        ensure!(calls.unit == "inputs" && lines.len() % 2 == 0, "{} has no empty loops", self.name);
        run.regions.resize(lines.len(), Region::new());
        let calls: f64 = calls.value.parse()?;
        let costs =
            lines.chunks(2).zip(run.regions.chunks(2)).enumerate().map(|(number, (lines, regions))| {
                ensure!(lines[0].name.starts_with(EMPTY), "{} comes without an empty loop", lines[1].name);
                let [idle, busy] = [0, 1].map(|region| program.split(&regions[region]));
                let sum = |split: &Split| split.values().sum::<u64>() as f64 / calls;
                let bytes = |split: &Split| split.keys().map(|(_, bytes)| bytes).sum::<u64>();
                let cycles = cycles.as_ref().map(|cycles| &cycles[2 * number..]);
                Ok(Cost {
                    name: lines[1].name.clone(),
                    instructions: sum(&busy) - sum(&idle),
                    bytes: bytes(&busy).saturating_sub(bytes(&idle)),
                    cycles: cycles.map(|cycles| (cycles[1] as f64 - cycles[0] as f64) / calls),
                    split: busy.into_iter().map(|(name, count)| (name, count as f64 / calls)).collect(),
                })
            });
        Ok((costs.collect::<Result<_>>()?, run))
    }
}

impl Run {
    /// The cycles of each region on an RP2040, if its core runs the firmware of the board.
    pub(crate) fn cycles(&mut self, board: &Board, progress: &Progress) -> Result<Option<Vec<u64>>> {
        if board.name != "cortex-m0" {
            return Ok(None);
        }
        let cycles = rp2040::cycles(&self.file, &self.text, &self.regions, progress)?;
        self.about[1].1 += &format!("; cycles by {}", rp2040::describe()?);
        Ok(Some(cycles))
    }

    /// A group of what the figures depend on.
    pub(crate) fn group(&self) -> Group {
        Group::about(&self.about)
    }
}

impl Cost {
    /// The instructions by function, in descending order.
    pub(crate) fn by_symbol(&self) -> String {
        let mut functions: Vec<_> = self.split.iter().collect();
        functions.sort_by(|a, b| b.1.total_cmp(a.1));
        let mut text = format!("{}\n", self.name);
        for ((name, bytes), instructions) in functions {
            // Without generic arguments: the types of a number format fill a page.
            let name = name.split("::<").next().unwrap_or(name);
            text += &format!("{instructions:10.2}  {bytes:5} bytes  {name}\n");
        }
        text + &format!("{:10.2}  instructions a call, without the empty loop\n", self.instructions)
    }
}

/// Rounds to thousandths.
pub(crate) fn thousandths(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

/// Builds programs for a board. They are among the artifacts of the returned toolchain.
pub(crate) fn build(board: &Board, options: &[&str], progress: &Progress) -> Result<Toolchain> {
    let toolchain = Toolchain::find(board.target, progress)?.with_flags(board.flags);
    toolchain.build(&project::root().join(FIRMWARE), options, progress)?;
    Ok(toolchain)
}

/// Checks that the counter counts known numbers of instructions, and that two runs give the same count at
/// every address.
pub(crate) fn is_exact(board: &'static Board, progress: &Progress) -> Result<()> {
    let file = Firmware::new("instrument", &[]).build(board, progress)?;
    let qemu = Qemu::find(board, progress)?;
    let (text, regions) = qemu.count(&file, progress)?;
    let lines = Line::all(&text)?;
    ensure!(!lines.is_empty(), "the firmware has printed nothing");
    for (number, Line { name, value, .. }) in lines.iter().enumerate() {
        let counted: u64 = regions.get(number).context("a region is missing")?.values().sum();
        ensure!(*value == counted.to_string(), "{name} counted as {counted} instructions, not {value}");
    }
    ensure!(qemu.count(&file, progress)?.1 == regions, "two runs were counted differently");
    Ok(())
}
