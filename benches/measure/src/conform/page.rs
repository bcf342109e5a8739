//! The check in a browser.

use std::fs;

use anyhow::{Context, Result};
use wasm_bindgen_cli_support::Bindgen;

use super::vectors;
use browser::Visit;
use tools::progress::Progress;
use tools::project;
use tools::server::{self, Server};
use tools::toolchain::Toolchain;
use tools::wasm::PROFILE;

pub(crate) const TARGET: &str = "wasm32-unknown-unknown";

/// Builds the page, opens it, and returns what it reports.
pub(crate) fn check(progress: &Progress) -> Result<String> {
    let toolchain = Toolchain::find(TARGET, progress)?;
    // The same flags as for the demo, so that the check holds for the demo's pixels.
    let mut build = toolchain.cargo_build("std,panic_abort", &["-Ctarget-feature=+simd128"]);
    build.args(["--package", "luminaire-conform-wasm", "--lib", "--profile", PROFILE]);
    progress.run(build)?;
    let module = toolchain.artifacts(PROFILE).join("luminaire_conform_wasm.wasm");

    let site = project::target().join("conform");
    let bound = Bindgen::new().input_path(&module).web(true).and_then(|bindgen| {
        bindgen.omit_default_module_path(false).typescript(false).generate(site.join("pkg"))
    });
    bound.with_context(|| format!("wasm-bindgen cannot make bindings for {}", module.display()))?;
    for (from, name) in [(vectors::folder().join("wasm"), "index.html"), (vectors::folder(), "vectors.txt")] {
        fs::copy(from.join(name), site.join(name)).with_context(|| format!("cannot copy {name}"))?;
    }

    let server = Server::start(server::listen(0)?, &site)?;
    let visit = Visit { address: &server.address(), ..Visit::default() };
    let report = visit.ask("document.getElementById('report').textContent", progress)?;
    Ok(report.as_str().context("the page has no report")?.to_owned())
}
