//! Shrinking a WebAssembly module with Binaryen's `wasm-opt`, if that can be found or installed.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};
use flate2::Compression;
use flate2::write::GzEncoder;

use crate::progress::Progress;
use crate::{command, install, project};

/// Enables every WebAssembly feature that the module uses: those that rustc enables by default, and
/// simd, which the demo enables.
const ARGUMENTS: [&str; 9] = [
    "-O3",
    // Large functions with a single caller are not inlined: the module is smaller, takes half the
    // time to build, and is no slower.
    "--one-caller-inline-max-function-size=40",
    "--enable-simd",
    "--enable-bulk-memory",
    "--enable-mutable-globals",
    "--enable-sign-ext",
    "--enable-nontrapping-float-to-int",
    "--enable-multivalue",
    "--enable-reference-types",
];

/// Shrinks the module in place. Without `wasm-opt` the demo works but is larger, so a missing
/// `wasm-opt` is reported and is no error.
pub(super) fn shrink(module: &Path, progress: &Progress) -> Result<()> {
    let full = sizes(module)?;
    let Some(wasm_opt) = find(progress) else {
        progress.say("Leaving", format_args!("{full}: no wasm-opt (install binaryen, or npm) to shrink it"));
        return Ok(());
    };
    let step = progress.begin("Shrinking", format_args!("with {}", project::shown(&wasm_opt)));
    let shrunk = module.with_extension("shrunk");
    let mut shrinking = Command::new(wasm_opt);
    shrinking.arg(module).arg("--output").arg(&shrunk).args(ARGUMENTS);
    if let Err(error) = progress.run(shrinking) {
        progress.say("Leaving", format_args!("{full}: {error:#}"));
        return Ok(());
    }
    fs::rename(&shrunk, module).with_context(|| format!("cannot replace {}", module.display()))?;
    step.done_with(format_args!("{full} before, {} after", sizes(module)?));
    Ok(())
}

/// `wasm-opt` from PATH or from the project's tools, else from npm.
fn find(progress: &Progress) -> Option<PathBuf> {
    command::on_path(&["wasm-opt"]).or_else(|| {
        install::npm("binaryen", progress).ok()?;
        install::npm_program("wasm-opt")
    })
}

/// The size of a file, plain and gzipped, for people.
fn sizes(file: &Path) -> Result<String> {
    let bytes = fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(&bytes)?;
    Ok(format!("{} ({} gzipped)", kilobytes(bytes.len()), kilobytes(encoder.finish()?.len())))
}

fn kilobytes(bytes: usize) -> String {
    format!("{:.1} kB", bytes as f64 / 1000.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_told_plain_and_gzipped() {
        let file = tempfile::NamedTempFile::new().unwrap();
        fs::write(file.path(), vec![0; 34_100]).unwrap();
        assert_eq!(sizes(file.path()).unwrap(), "34.1 kB (0.1 kB gzipped)");
    }
}
