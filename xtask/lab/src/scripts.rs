//! The checks of the page's scripts: types, rules and unit tests.

use std::fs;
use std::process::Command;

use anyhow::{Context, Result};
use serde_json::json;
use tools::demo::site::Build;
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::wasm;
use tools::{install, project};

/// The page, its settings for TypeScript, and its unit tests.
const PAGE: &str = "wasm-demo/web";
const SETTINGS: &str = "wasm-demo/tsconfig.json";
const TESTS: &str = "wasm-demo/tests";

/// Adds the steps. The demo's modules should be compiled already: the types are those of their
/// bindings.
pub(crate) fn run(suite: &mut Suite, build: Build) {
    suite.step("scripts: types", |progress| types(build, progress));
    suite.step("scripts: rules", rules);
    suite.count("scripts: unit tests", unit_tests);
}

/// Checks the types of the scripts, also at their calls of the module.
fn types(build: Build, progress: &Progress) -> Result<()> {
    let folder = project::target().join("types");
    for (package, bindings) in wasm::PAGE {
        package.bind(&package.compile(build.profile(), progress)?, &folder.join(bindings), progress)?;
    }
    let (root, page) = (project::root(), project::root().join(PAGE));
    let settings = json!({
        "extends": root.join(SETTINGS),
        // The bindings are in a folder of the page once it is built.
        "compilerOptions": { "rootDirs": [page, folder] },
        "include": [page],
    });
    fs::write(folder.join("tsconfig.json"), settings.to_string())?;
    install::npm("typescript", progress)?;
    let mut check = node_program("tsc")?;
    check.args(["--pretty", "false", "--project"]).arg(&folder).current_dir(root);
    progress.run(check)
}

/// Checks the scripts against the recommended rules of ESLint.
fn rules(progress: &Progress) -> Result<()> {
    let folder = install::npm("eslint", progress)?;
    // Beside the packages that it imports.
    let rules = folder.with_file_name("eslint.config.mjs");
    fs::copy(project::root().join("xtask/tools/npm/eslint.config.mjs"), &rules)?;
    let mut check = node_program("eslint")?;
    check.current_dir(project::root()).arg("--config").arg(rules);
    check.args(["--max-warnings=0", "wasm-demo", "xtask/browser"]);
    progress.run(check)
}

fn unit_tests(progress: &Progress) -> Result<Tally> {
    let mut test = Command::new(install::node(progress)?);
    test.arg("--test").current_dir(project::root().join(TESTS));
    tally::node_test(test, progress)
}

fn node_program(name: &str) -> Result<Command> {
    Ok(Command::new(install::npm_program(name).with_context(|| format!("npm has not installed {name}"))?))
}
