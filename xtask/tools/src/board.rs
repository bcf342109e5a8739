//! Building the firmware of boards, and the emulators that run it.

use std::path::PathBuf;
use std::process::Command;

use anyhow::Result;

use crate::progress::Progress;
use crate::toolchain::Toolchain;
use crate::{command, install, project, tool};

/// The emulator's npm package. The recorded cycles are from the version of `xtask/tools/npm`.
pub const RP2040JS: &str = "rp2040js";

/// The board, which is also the folder of its package.
pub const RP2040: &str = "rp2040";

/// The target that its firmware is compiled for.
pub const TARGET: &str = "thumbv6m-none-eabi";

/// A call of cargo in a folder of `examples/boards`.
pub fn cargo<const N: usize>(name: &str, words: [&str; N]) -> Command {
    let mut cargo = command::cargo(words);
    cargo.current_dir(folder(name));
    cargo
}

fn folder(name: &str) -> PathBuf {
    project::root().join("examples/boards").join(name)
}

/// The console, which is also the folder of its package.
pub const GBA: &str = "gba";

/// The target that the console's program is compiled for.
const GBA_TARGET: &str = "armv4t-none-eabi";

/// The runner of the console's program in mGBA, for the compiler of C.
const GBA_RUNNER: &str = "examples/boards/emulator/gba.c";

/// Builds the firmware of the board. Returns its file.
pub fn build(progress: &Progress) -> Result<PathBuf> {
    build_for(RP2040, TARGET, progress)
}

/// Builds the program of the console. Returns its file, in ELF.
pub fn build_console(progress: &Progress) -> Result<PathBuf> {
    build_for(GBA, GBA_TARGET, progress)
}

fn build_for(name: &str, target: &'static str, progress: &Progress) -> Result<PathBuf> {
    let toolchain = Toolchain::find(target, progress)?;
    toolchain.build(&folder(name), &["--release"], progress)?;
    Ok(toolchain.artifacts("release").join(format!("luminaire-{name}")))
}

/// Compiles the console's emulator, mGBA without a window, below `target`. As root on Debian, installs what is missing.
/// Returns its file.
pub fn console(progress: &Progress) -> Result<PathBuf> {
    install::program(&tool::MGBA, progress)?;
    let mut compile = Command::new(install::program(&tool::CC, progress)?);
    let runner = project::target().join("gba-emulator");
    compile.args(["-O2", "-Wall", "-Wextra", "-Werror", "-o"]).arg(&runner);
    compile.arg(project::root().join(GBA_RUNNER)).arg("-lmgba");
    progress.run(compile)?;
    Ok(runner)
}

/// Finds the folder of the emulator of an RP2040, or installs it below `target`.
pub fn emulator(progress: &Progress) -> Result<PathBuf> {
    install::npm(RP2040JS, progress)
}
