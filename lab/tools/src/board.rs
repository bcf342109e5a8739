//! Building the firmware of a board, and the emulator that runs it.

use std::path::PathBuf;
use std::process::Command;

use anyhow::Result;

use crate::progress::Progress;
use crate::toolchain::Toolchain;
use crate::{install, project};

/// The emulator's npm package. The recorded cycles are from the version of `lab/tools/npm`.
pub const RP2040JS: &str = "rp2040js";

/// Makes a call of cargo run in a folder of `boards`.
pub fn in_folder(name: &str, mut cargo: Command) -> Command {
    cargo.current_dir(project::root().join("boards").join(name));
    cargo
}

/// Builds the firmware in a folder of `boards` for a target. Returns its file.
pub fn build(name: &str, target: &'static str, progress: &Progress) -> Result<PathBuf> {
    let toolchain = Toolchain::find(target, progress)?;
    let mut build = in_folder(name, toolchain.cargo_build("core", &[]));
    build.arg("--release");
    progress.run(build)?;
    Ok(toolchain.artifacts("release").join(format!("luminaire-{name}")))
}

/// Finds the folder of the emulator of an RP2040, or installs it below `target`.
pub fn emulator(progress: &Progress) -> Result<PathBuf> {
    install::npm(RP2040JS, progress)
}
