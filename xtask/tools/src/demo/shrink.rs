//! How the modules of the demo are built, and shrunk with Binaryen's `wasm-opt`, if that can be found or
//! installed.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::progress::Progress;
use crate::wasm::Package;
use crate::{command, install, project, wasm};

/// Enables every WebAssembly feature that the module uses: those that rustc enables by default, and
/// simd, which the demo enables.
const ARGUMENTS: [&str; 10] = [
    "-O3",
    // Again until nothing changes: the stage is 1.1 kB smaller by gzip than after one pass.
    "--converge",
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

/// How the demo is built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Build {
    /// Without the view of the chip, whose firmware is built for another target.
    Part,
    /// All of it.
    Whole,
    /// All of it as it is published: with link-time optimisation, and shrunk by `wasm-opt`.
    Small,
}

impl Build {
    /// The profile of its modules.
    pub fn profile(self) -> &'static str {
        if self == Self::Small { wasm::PUBLISHED } else { wasm::LOCAL }
    }

    /// Compiles a module and binds it. Returns the folder of its bindings, which is kept until the module
    /// changes.
    pub fn bound(self, package: &Package, progress: &Progress) -> Result<PathBuf> {
        let module = package.compile(self.profile(), progress)?;
        let kept = project::target().join("bound").join(self.profile()).join(package.part());
        // The module that it was bound from.
        let source = kept.with_extension("wasm");
        let bytes = fs::read(&module).with_context(|| format!("cannot read {}", module.display()))?;
        if !kept.is_dir() || !fs::read(&source).is_ok_and(|before| before == bytes) {
            project::renew(&kept, |new| self.finish(&package.bind(&module, new, progress)?, progress))?;
            project::replace(&source, &bytes)?;
        }
        Ok(kept)
    }

    /// Makes a bound module what the page loads.
    fn finish(self, module: &Path, progress: &Progress) -> Result<()> {
        if self == Self::Small { shrink(module, progress) } else { Ok(()) }
    }
}

/// Shrinks the module in place. Without `wasm-opt` the demo works but is larger, so a missing
/// `wasm-opt` is reported and is no error.
fn shrink(module: &Path, progress: &Progress) -> Result<()> {
    let mut shrinking = match find(progress) {
        Ok(wasm_opt) => wasm_opt,
        Err(error) => {
            progress.say("Leaving", format_args!("{} as it is: no wasm-opt: {error:#}", module.display()));
            return Ok(());
        }
    };
    let kilobytes = || fs::metadata(module).map_or(0, |file| file.len() / 1000);
    let (before, shrunk) = (kilobytes(), module.with_extension("shrunk"));
    shrinking.arg(module).arg("--output").arg(&shrunk).args(ARGUMENTS);
    progress.timed("Shrinking", project::shown(module), || progress.run(shrinking))?;
    fs::rename(&shrunk, module).with_context(|| format!("cannot replace {}", module.display()))?;
    progress.say("Shrunk", format_args!("{before} kB before, {} kB after", kilobytes()));
    Ok(())
}

/// A call of `wasm-opt` from PATH, else from npm.
fn find(progress: &Progress) -> Result<Command> {
    let own = command::on_path(&["wasm-opt"]).map(Command::new);
    own.map_or_else(|| install::npm_program("binaryen", "wasm-opt", progress), Ok)
}
