//! The checks of the page's scripts: types, rules and unit tests.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result};
use serde_json::json;
use tools::demo::site::{self, Build};
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::{install, project, tool};

/// The page, its settings for TypeScript, and its unit tests.
const PAGE: &str = "wasm-demo/web";
const SETTINGS: &str = "wasm-demo/tsconfig.json";
const TESTS: &str = "wasm-demo/tests";

/// Adds the steps. The demo should be built already: the types are those of its bindings.
pub(crate) fn run(suite: &mut Suite, build: Build) {
    let is_built = !suite.is_selective();
    suite.step("scripts: types", |progress| {
        let site = if is_built { site::folder(build) } else { site::build(build, progress)? };
        types(&site, progress)
    });
    suite.step("scripts: rules", rules);
    suite.count("scripts: unit tests", unit_tests);
}

/// Checks the types of the scripts, also at their calls of the module.
fn types(site: &Path, progress: &Progress) -> Result<()> {
    let folder = project::target().join("types");
    fs::create_dir_all(&folder).with_context(|| format!("cannot create {}", folder.display()))?;
    let (root, page) = (project::root(), project::root().join(PAGE));
    let settings = json!({
        "extends": root.join(SETTINGS),
        // The bindings are in folders of the demo.
        "compilerOptions": { "rootDirs": [page, site] },
        "include": [page],
    });
    fs::write(folder.join("tsconfig.json"), settings.to_string())?;
    let mut check = install::npm_program("typescript", "tsc", progress)?;
    check.args(["--pretty", "false", "--project"]).arg(&folder).current_dir(root);
    progress.run(check)
}

/// Checks the scripts against the recommended rules of ESLint.
fn rules(progress: &Progress) -> Result<()> {
    let folder = install::npm("eslint", progress)?;
    // Beside the packages that it imports.
    let rules = folder.with_file_name("eslint.config.mjs");
    fs::copy(project::root().join("xtask/tools/npm/eslint.config.mjs"), &rules)?;
    let mut check = install::npm_program("eslint", "eslint", progress)?;
    check.current_dir(project::root()).arg("--config").arg(rules);
    check.args(["--max-warnings=0", "wasm-demo", "xtask/browser"]);
    progress.run(check)
}

fn unit_tests(progress: &Progress) -> Result<Tally> {
    let mut test = Command::new(install::program(&tool::NODE, progress)?);
    test.arg("--test").current_dir(project::root().join(TESTS));
    tally::node_test(test, progress)
}
