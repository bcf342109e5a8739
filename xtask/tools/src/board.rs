//! Building the firmware of a board, and the emulator that runs it.

use std::path::PathBuf;
use std::process::Command;

use anyhow::Result;

use crate::progress::Progress;
use crate::toolchain::Toolchain;
use crate::{command, install, project};

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

/// Builds the firmware of the board. Returns its file.
pub fn build(progress: &Progress) -> Result<PathBuf> {
    let toolchain = Toolchain::find(TARGET, progress)?;
    toolchain.build(&folder(RP2040), &["--release"], progress)?;
    Ok(toolchain.artifacts("release").join(format!("luminaire-{RP2040}")))
}

/// Finds the folder of the emulator of an RP2040, or installs it below `target`.
pub fn emulator(progress: &Progress) -> Result<PathBuf> {
    install::npm(RP2040JS, progress)
}
