//! Compares the public API with that of the last release.

use std::process::Command;

use tools::suite::Suite;
use tools::{command, install, project};

use crate::features;

/// Adds the step.
pub(crate) fn run(suite: &mut Suite) {
    suite.remarked("semver: the version says what has changed since the last release", |progress| {
        let Some(tag) = last_release() else {
            return Ok(vec!["there is no tag v* to compare with".to_owned()]);
        };
        let program = install::cargo_program("cargo-semver-checks", progress)?;
        for package in ["luminaire", "luminaire-render"] {
            let mut check = Command::new(&program);
            check.args(["semver-checks", "--package", package, "--baseline-rev", &tag]);
            check.current_dir(project::root()).env("CARGO_TARGET_DIR", project::target().join("semver"));
            if package == "luminaire" {
                // The feature `arithmetic` is not covered by the promise of stability.
                let promised = features::names()?.into_iter().filter(|name| name != "arithmetic");
                let promised = promised.collect::<Vec<_>>().join(",");
                check.args(["--only-explicit-features", "--features", &promised]);
            }
            progress.run(check)?;
        }
        Ok(vec![format!("compared with {tag}")])
    });
}

/// The tag of the last release, if there is one.
fn last_release() -> Option<String> {
    let mut describe = Command::new("git");
    describe.args(["describe", "--tags", "--abbrev=0", "--match", "v*"]).current_dir(project::root());
    command::answer(&mut describe).ok()
}
