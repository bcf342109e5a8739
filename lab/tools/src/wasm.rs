//! Compiling a package to WebAssembly, and its bindings to JavaScript.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use wasm_bindgen_cli_support::Bindgen;

use crate::progress::Progress;
use crate::toolchain::Toolchain;

const TARGET: &str = "wasm32-unknown-unknown";
const PROFILE: &str = "wasm";

/// A package that a browser runs.
#[derive(Debug)]
pub struct Package {
    name: &'static str,
    /// The name of its library, as in file names.
    library: &'static str,
    /// The features that it is compiled with; `None` for its default features.
    features: Option<&'static str>,
    /// The name of its bindings, as in file names.
    bindings: &'static str,
    /// Whether it may use the vector instructions.
    simd: bool,
}

/// The demo's stage, which uses the vector instructions, and draws pictures in `f32`.
pub const DEMO: Package = Package {
    name: "wasm-demo",
    library: "wasm_demo",
    features: Some("stage"),
    bindings: "wasm_demo",
    simd: true,
};
/// The demo's comparison, a module of its own: the first picture does not wait for it.
pub const COMPARISON: Package = Package { features: Some("comparison"), bindings: "comparison", ..DEMO };
/// What draws the demo's pictures in fixed point, a module of its own: the first picture is in `f32`.
pub const FIXED_POINT: Package = Package { features: Some("fixed-point"), bindings: "fixed_point", ..DEMO };
/// The demo's exporter of lights, a module of its own: it is loaded when its drawer is opened.
pub const CODE: Package = Package { features: Some("code"), bindings: "code", ..DEMO };
/// What the board of the demo must show. It shares the demo's standard library.
pub const CHIP: Package = Package::new("luminaire-chip", "luminaire_chip", true);
/// The picker of evaluations. It shares the demo's standard library.
pub const PICKER: Package = Package::new("luminaire-price", "luminaire_price", true);
/// The modules of the demo's page, and the folders of their bindings on it. The chip's is apart: it
/// has the firmware beside it.
pub const PAGE: [(Package, &str); 5] =
    [(DEMO, "pkg"), (FIXED_POINT, "pkg"), (COMPARISON, "pkg"), (CODE, "pkg"), (PICKER, "price")];
/// The program that times the kernels.
pub const PRICES: Package = Package::new("luminaire-prices", "luminaire_prices", false);
/// The program that times the kernels, with vector instructions.
pub const SIMD_PRICES: Package = Package { simd: true, ..PRICES };

/// The compiler that packages are compiled with, as in `rustc 1.96.0`.
pub fn compiler(progress: &Progress) -> Result<String> {
    Toolchain::find(TARGET, progress)?.compiler()
}

impl Package {
    /// A package with its default features, whose bindings have the name of its library.
    const fn new(name: &'static str, library: &'static str, simd: bool) -> Self {
        Self { name, library, features: None, bindings: library, simd }
    }

    /// The compiler's flags.
    pub fn flags(&self) -> &'static [&'static str] {
        if self.simd { &["-Ctarget-feature=+simd128"] } else { &[] }
    }

    /// Compiles the package. The resulting module still needs its bindings. The next compilation of
    /// the same package with other features replaces it.
    pub fn compile(&self, progress: &Progress) -> Result<PathBuf> {
        let toolchain = Toolchain::find(TARGET, progress)?;
        let step = progress.begin("Building", format_args!("{} for {}", self.name, toolchain.describe()));
        let mut build = toolchain.cargo_build("std,panic_abort", self.flags());
        build.args(["--package", self.name, "--lib", "--profile", PROFILE]);
        if let Some(features) = self.features {
            build.args(["--no-default-features", "--features", features]);
        }
        progress.run(build)?;
        step.done();
        Ok(toolchain.artifacts(PROFILE).join(format!("{}.wasm", self.library)))
    }

    /// Writes the bindings and the bound module into `folder`. Returns the path of
    /// the bound module.
    pub fn bind(&self, module: &Path, folder: &Path, progress: &Progress) -> Result<PathBuf> {
        let step = progress.begin("Binding", format_args!("{}.wasm to JavaScript", self.library));
        self.generate(module, folder, false)?;
        step.done();
        Ok(folder.join(format!("{}_bg.wasm", self.bindings)))
    }

    /// Writes the types of the bindings into `folder`, for checks of the scripts that use them.
    pub fn declare(&self, module: &Path, folder: &Path) -> Result<()> {
        let bound = tempfile::tempdir()?;
        self.generate(module, bound.path(), true)?;
        fs::create_dir_all(folder)?;
        let name = format!("{}.d.ts", self.bindings);
        fs::copy(bound.path().join(&name), folder.join(&name))?;
        Ok(())
    }

    fn generate(&self, module: &Path, folder: &Path, with_types: bool) -> Result<()> {
        let mut bindgen = Bindgen::new();
        bindgen.input_path(module).out_name(self.bindings).typescript(with_types);
        // Pages that call `init()` without a path rely on bindings that know where their module is.
        let bound =
            bindgen.web(true).and_then(|bindgen| bindgen.omit_default_module_path(false).generate(folder));
        bound.with_context(|| format!("wasm-bindgen cannot make bindings for {}", module.display()))
    }
}
