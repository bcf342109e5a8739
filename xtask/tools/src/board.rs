//! Building the firmware of a board, and the emulator that runs it.

use std::path::PathBuf;
use std::process::Command;

use anyhow::Result;

use crate::progress::Progress;
use crate::toolchain::Toolchain;
use crate::{install, project};

/// The emulator's npm package. The recorded cycles are from the version of `xtask/tools/npm`.
pub const RP2040JS: &str = "rp2040js";

/// The board, which is also the folder of its package.
pub const RP2040: &str = "rp2040";

/// The target that its firmware is compiled for.
pub const TARGET: &str = "thumbv6m-none-eabi";

/// Makes a call of cargo run in a folder of `examples/boards`.
pub fn in_folder(name: &str, mut cargo: Command) -> Command {
    cargo.current_dir(project::root().join("examples/boards").join(name));
    cargo
}

/// Builds the firmware of the board. Returns its file.
pub fn build(progress: &Progress) -> Result<PathBuf> {
    let toolchain = Toolchain::find(TARGET, progress)?;
    let mut build = in_folder(RP2040, toolchain.cargo_build("core", &[]));
    build.arg("--release");
    progress.run(build)?;
    Ok(toolchain.artifacts("release").join(format!("luminaire-{RP2040}")))
}

/// Finds the folder of the emulator of an RP2040, or installs it below `target`.
pub fn emulator(progress: &Progress) -> Result<PathBuf> {
    install::npm(RP2040JS, progress)
}
