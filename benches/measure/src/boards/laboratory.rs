//! A board with everything that is needed to count instructions on it.

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX, EXE_SUFFIX};
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Result, bail};

use super::board::Board;
use super::counts::{self, Region};
use super::emulator::Emulator;
use tools::progress::Progress;
use tools::toolchain::Toolchain;
use tools::{command, project};

/// The folder of the firmware.
const FIRMWARE: &str = "benches/firmware";

/// The profile of programs that are optimised for speed.
pub(crate) const RELEASE: &str = "release";
/// The profile of programs that are optimised for size.
pub(crate) const SIZE: &str = "size";

/// A board, its emulator, the counter that is loaded into it, and the folder of the firmware.
#[derive(Debug)]
pub(crate) struct Laboratory {
    board: &'static Board,
    emulator: Emulator,
    counter: PathBuf,
    programs: PathBuf,
}

/// The result of a program: the lines that it printed, and the counted regions.
#[derive(Debug, PartialEq)]
pub(crate) struct Run {
    pub(crate) lines: Vec<String>,
    pub(crate) regions: Vec<Region>,
}

impl Laboratory {
    /// Finds or installs the emulator, and builds the counter and the board's firmware.
    pub(crate) fn new(board: &'static Board, progress: &Progress) -> Result<Self> {
        Self::with(FIRMWARE, &["--bins"], RELEASE, board, progress)
    }

    /// Like [`new`](Self::new), but builds only one program, which is faster.
    pub(crate) fn with_program(name: &str, board: &'static Board, progress: &Progress) -> Result<Self> {
        Self::with(FIRMWARE, &["--bin", name], RELEASE, board, progress)
    }

    /// Like [`with_program`](Self::with_program), of another workspace than the firmware's.
    pub(crate) fn with_program_of(
        folder: &str,
        name: &str,
        board: &'static Board,
        progress: &Progress,
    ) -> Result<Self> {
        Self::with(folder, &["--bin", name], RELEASE, board, progress)
    }

    /// Like [`with_program`](Self::with_program), with a feature of the firmware, in one of its
    /// profiles.
    pub(crate) fn with_feature(
        name: &str,
        feature: &str,
        profile: &str,
        board: &'static Board,
        progress: &Progress,
    ) -> Result<Self> {
        Self::with(FIRMWARE, &["--bin", name, "--features", feature], profile, board, progress)
    }

    fn with(
        folder: &str,
        programs: &[&str],
        profile: &str,
        board: &'static Board,
        progress: &Progress,
    ) -> Result<Self> {
        let emulator = Emulator::find(board, progress)?;
        let step =
            progress.begin("Building", format_args!("the counter and the firmware for {}", board.name));
        let counter = build_counter(&emulator, progress)?;
        let toolchain = build_in(folder, board, &[&["--profile", profile], programs].concat(), progress)?;
        step.done();
        Ok(Self { board, emulator, counter, programs: toolchain.artifacts(profile) })
    }

    /// The emulator and the board, as in `QEMU 7.2, -M microbit`.
    pub(crate) fn emulator(&self) -> String {
        self.emulator.describe()
    }

    /// The file of a firmware program.
    pub(crate) fn program(&self, name: &str) -> PathBuf {
        self.programs.join(name)
    }

    /// Runs a firmware program, which prints one line for each region.
    pub(crate) fn run(&self, name: &str) -> Result<Run> {
        self.run_with(name, <[String]>::len)
    }

    /// Runs a firmware program. `regions` computes the number of its regions from the lines that it
    /// prints.
    pub(crate) fn run_with(&self, name: &str, regions: impl FnOnce(&[String]) -> usize) -> Result<Run> {
        let file = project::target().join(format!("{name}-{}.counts", self.board.name));
        let output = self.emulator.run(&self.program(name), &self.counter, &file)?;
        let lines: Vec<_> = output.lines().map(str::to_owned).collect();
        let regions = counts::read(&file, regions(&lines))?;
        Ok(Run { lines, regions })
    }
}

/// Returns what a firmware program prints on the host. The results of the host are right by
/// definition.
pub(crate) fn on_the_host(name: &str, progress: &Progress) -> Result<Vec<String>> {
    on_the_host_with(FIRMWARE, name, &[], progress)
}

/// Like [`on_the_host`], of a program of another workspace than the firmware's.
pub(crate) fn on_the_host_of(folder: &str, name: &str, progress: &Progress) -> Result<Vec<String>> {
    on_the_host_with(folder, name, &[], progress)
}

/// Like [`on_the_host`], with a feature of the firmware.
pub(crate) fn on_the_host_with_feature(
    name: &str,
    feature: &str,
    progress: &Progress,
) -> Result<Vec<String>> {
    on_the_host_with(FIRMWARE, name, &["--features", feature], progress)
}

fn on_the_host_with(folder: &str, name: &str, features: &[&str], progress: &Progress) -> Result<Vec<String>> {
    let mut build = command::cargo("build");
    build.current_dir(project::root().join(folder));
    build.args(["--release", "--bin", name]).args(features);
    progress.run(build)?;
    let program = project::target().join("release").join(format!("{name}{EXE_SUFFIX}"));
    Ok(command::answer(&mut Command::new(program))?.lines().map(str::to_owned).collect())
}

/// Builds firmware for a board. The programs are among the artifacts of the returned toolchain.
pub(crate) fn build(board: &Board, arguments: &[&str], progress: &Progress) -> Result<Toolchain> {
    build_in(FIRMWARE, board, arguments, progress)
}

fn build_in(folder: &str, board: &Board, arguments: &[&str], progress: &Progress) -> Result<Toolchain> {
    let toolchain = Toolchain::find(board.target, progress)?;
    let mut build = toolchain.cargo_build("core", &[]);
    build.args(arguments).current_dir(project::root().join(folder));
    progress.run(build)?;
    Ok(toolchain)
}

/// Builds firmware for many boards side by side. Linking a program, or compiling a board's library,
/// keeps only one of the machine's processors busy, so building board after board would leave the
/// others idle.
pub(crate) fn build_for_all(boards: &[&Board], arguments: &[&str], progress: &Progress) -> Result<()> {
    // In one call, Cargo unifies the features that the start-up macros of all its boards require.
    // After a call with both Arm and RISC-V boards, building one board alone would compile
    // everything again.
    for boards in boards.chunk_by(|one, next| one.emulator == next.emulator) {
        let toolchains = boards.iter().map(|board| Toolchain::find(board.target, progress));
        for mut build in Toolchain::cargo_builds(&toolchains.collect::<Result<Vec<_>>>()?, "core", &[]) {
            build.args(arguments);
            progress.run(firmware(build))?;
        }
    }
    Ok(())
}

/// Makes a call of cargo run in the firmware's workspace.
pub(crate) fn firmware(mut cargo: Command) -> Command {
    cargo.current_dir(project::root().join(FIRMWARE));
    cargo
}

fn build_counter(emulator: &Emulator, progress: &Progress) -> Result<PathBuf> {
    let mut build = command::cargo("build");
    build.args(["--release", "--package", "luminaire-counter"]);
    if emulator.wants_api_3() {
        build.args(["--features", "api-3"]);
    }
    progress.run(build)?;
    let file = project::target().join("release").join(format!("{DLL_PREFIX}luminaire_counter{DLL_SUFFIX}"));
    if !file.is_file() {
        bail!("cargo has not built {}", file.display());
    }
    Ok(file)
}
