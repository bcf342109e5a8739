//! Compiling a package to WebAssembly, and its bindings to JavaScript.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use wasm_bindgen_cli_support::Bindgen;

use crate::progress::Progress;
use crate::toolchain::Toolchain;

const TARGET: &str = "wasm32-unknown-unknown";

/// The profile in the workspace's manifest of what is tried and tested on this machine.
pub const LOCAL: &str = "wasm";
/// The profile of what is published or timed.
pub const PUBLISHED: &str = "published";

/// A package that a browser runs.
#[derive(Debug)]
pub struct Package {
    name: &'static str,
    /// The name of its bindings, as in file names.
    bindings: &'static str,
    /// Whether it may use the vector instructions.
    simd: bool,
}

/// What the board of the demo must show.
pub const CHIP: Package = Package::new("luminaire-chip", "luminaire_chip");
/// The modules of the demo's page, and the folders of their bindings on it, in the order in which a
/// visitor is likely to need them: the stage, which draws pictures in 16 bits, and what is loaded when
/// it is first needed. The chip's is apart: it has the firmware beside it.
pub const PAGE: [(Package, &str); 7] = [
    (Package::new("demo-stage", "wasm_demo"), "pkg"),
    (Package::new("demo-wide", "wide"), "pkg"),
    (Package::new("luminaire-price", "luminaire_price"), "price"),
    (Package::new("demo-code", "code"), "pkg"),
    (Package::new("demo-comparison", "comparison"), "pkg"),
    (Package::new("demo-class", "class"), "pkg"),
    (Package::new("demo-files", "files"), "pkg"),
];
/// The check of the conformance vectors.
pub const CONFORM: Package = Package::new("luminaire-conform-wasm", "luminaire_conform_wasm");
/// The program that times the kernels.
pub const PRICES: Package = Package { simd: false, ..SIMD_PRICES };
/// The program that times the kernels, with vector instructions.
pub const SIMD_PRICES: Package = Package::new("luminaire-prices", "luminaire_prices");

/// The compiler that packages are compiled with, as in `rustc 1.96.0`.
pub fn compiler(progress: &Progress) -> Result<String> {
    Toolchain::find(TARGET, progress)?.compiler()
}

impl Package {
    const fn new(name: &'static str, bindings: &'static str) -> Self {
        Self { name, bindings, simd: true }
    }

    /// The part of the demo that it is: the last word of its name.
    pub fn part(&self) -> &'static str {
        self.name.rsplit('-').next().unwrap_or(self.name)
    }

    /// The flags of the compiler.
    pub fn flags(&self) -> &'static str {
        if self.simd { "-Ctarget-feature=+simd128" } else { "" }
    }

    /// Compiles the package in a profile. The resulting module still needs its bindings.
    pub fn compile(&self, profile: &str, progress: &Progress) -> Result<PathBuf> {
        let toolchain = Toolchain::find(TARGET, progress)?;
        let words = ["build", "--package", self.name, "--lib", "--profile", profile];
        let mut build = toolchain.cargo("std,panic_abort", words);
        build.env("CARGO_ENCODED_RUSTFLAGS", self.flags());
        let what = format_args!("{} for {}", self.name, toolchain.describe());
        progress.timed("Building", what, || progress.run(build))?;
        Ok(toolchain.artifacts(profile).join(format!("{}.wasm", self.name.replace('-', "_"))))
    }

    /// Writes the bindings, their types and the bound module into `folder`. Returns the path of the
    /// bound module.
    pub fn bind(&self, module: &Path, folder: &Path, progress: &Progress) -> Result<PathBuf> {
        let mut bindgen = Bindgen::new();
        // Pages that call `init()` without a path rely on bindings that know where their module is.
        bindgen.input_path(module).out_name(self.bindings).typescript(true);
        progress.timed("Binding", format_args!("{} to JavaScript", self.name), || {
            let bound = bindgen.web(true)?.omit_default_module_path(false).generate(folder);
            bound.with_context(|| format!("wasm-bindgen cannot make bindings for {}", module.display()))
        })?;
        Ok(folder.join(format!("{}_bg.wasm", self.bindings)))
    }
}
