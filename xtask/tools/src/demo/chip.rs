//! The board of the demo that runs in the page: firmware, an emulator in a worker, and the pictures
//! that its display must receive.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use super::licenses;
use super::shrink::Build;
use crate::board::RP2040;
use crate::progress::Progress;
use crate::{board, install, project, wasm};

/// Writes the firmware, the worker and the module into the demo's folder. Without npm, the demo is
/// complete but for this view, so that a missing npm is no error: returns why it is left out.
pub(super) fn write(site: &Path, build: Build, progress: &Progress) -> Result<Option<String>> {
    let emulator = match tools(progress) {
        Ok(emulator) => emulator,
        Err(error) => return Ok(Some(format!("{error:#}"))),
    };
    let what = format_args!("the firmware of the {RP2040}");
    let firmware = progress.timed("Building", what, || board::build(progress))?;
    let bindings = build.bound(&wasm::CHIP, progress)?;
    copy(&firmware, &site.join(format!("{RP2040}.elf")))?;
    bundle(site, progress)?;
    licenses::write(&site.join("chip-licenses.txt"), &emulator)?;
    project::add(&bindings, &site.join("chip")).map(|()| None)
}

/// Whether a folder of the demo has them.
pub(super) fn is_in(site: &Path) -> bool {
    site.join(format!("{RP2040}.elf")).is_file()
}

/// Finds or installs what bundles the worker. Returns the emulator's folder.
fn tools(progress: &Progress) -> Result<PathBuf> {
    install::npm("esbuild", progress)?;
    board::emulator(progress)
}

/// Bundles the worker with what it imports, so that a browser loads one small file, but for the bindings of the module, whose address it
/// needs.
fn bundle(site: &Path, progress: &Progress) -> Result<()> {
    let mut bundle = install::npm_program("esbuild", "esbuild", progress)?;
    bundle.arg(project::root().join("wasm-demo/chip/worker.js"));
    bundle.args(["--bundle", "--minify", "--format=esm", "--external:./chip/*", "--log-level=error"]);
    bundle.arg(format!("--outfile={}", site.join("chip-worker.js").display()));
    bundle.env("NODE_PATH", install::npm_modules());
    progress.run(bundle)
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::copy(from, to).map(drop).with_context(|| format!("cannot copy {}", from.display()))
}
