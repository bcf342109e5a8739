//! Compiling the demo to WebAssembly, and its bindings to JavaScript.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use wasm_bindgen_cli_support::Bindgen;

use crate::progress::Progress;
use crate::toolchain::Toolchain;

const TARGET: &str = "wasm32-unknown-unknown";
const PROFILE: &str = "wasm";

/// Compiles the demo; the module that comes out still needs its bindings.
pub(crate) fn compile(progress: &Progress) -> Result<PathBuf> {
    let toolchain = Toolchain::find(TARGET, progress)?;
    let step = progress.begin("Building", format_args!("wasm-demo for {}", toolchain.describe()));
    let mut build = toolchain.cargo_build("std,panic_abort", &["-Ctarget-feature=+simd128"]);
    build.args(["--package", "wasm-demo", "--lib", "--profile", PROFILE]);
    progress.run(build)?;
    step.done();
    Ok(toolchain.artifacts(PROFILE).join("wasm_demo.wasm"))
}

/// Writes `wasm_demo.js` and `wasm_demo_bg.wasm` into `folder`; answers the latter's path.
pub(crate) fn bind(module: &Path, folder: &Path, progress: &Progress) -> Result<PathBuf> {
    let step = progress.begin("Binding", "wasm_demo.wasm to JavaScript");
    let bound = Bindgen::new()
        .input_path(module)
        .web(true)
        // The page calls `init()` without a path, so the bindings must know where their module is.
        .and_then(|bindgen| bindgen.omit_default_module_path(false).typescript(false).generate(folder));
    bound.with_context(|| format!("wasm-bindgen cannot make bindings for {}", module.display()))?;
    step.done();
    Ok(folder.join("wasm_demo_bg.wasm"))
}
