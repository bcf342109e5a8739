//! A checkout as git for Windows makes it by default: without symbolic links, and with CRLF at the end of
//! each line where `.gitattributes` says nothing else. By hand:
//!
//! ```sh
//! git -c core.symlinks=false -c core.autocrlf=true clone . target/portable/windows
//! cd target/portable/windows && cargo test
//! ```

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::{command, project};

use crate::package;

/// The packages whose tests read files of the repository.
const PACKAGES: [&str; 3] = ["luminaire-exchange", "tools", "xtask"];

/// The settings of git on Windows and on Linux.
const WINDOWS: [&str; 2] = ["core.symlinks=false", "core.autocrlf=true"];
const LINUX: [&str; 2] = ["core.symlinks=true", "core.autocrlf=false"];

/// Adds the steps. They see what is committed.
pub(crate) fn run(suite: &mut Suite) {
    const NAMES: [&str; 3] = [
        "portable: a checkout on Windows has the same bytes",
        "portable: the crates are packed from a checkout on Windows",
        "portable: tests that read files pass in a checkout on Windows",
    ];
    if !NAMES.iter().any(|name| suite.wants(name)) {
        NAMES.iter().for_each(|name| suite.skip(name));
        return;
    }
    let tree = suite.require(NAMES[0], checkout);
    let tree = || tree.as_deref().context("there is no checkout");
    suite.step(NAMES[1], |progress| package::pack(tree()?, &folder().join("target"), progress).map(drop));
    suite.count(NAMES[2], |progress| tests(tree()?, progress));
}

/// The folder of the checkouts.
fn folder() -> PathBuf {
    project::target().join("portable")
}

/// Makes a checkout as on Windows, and compares it with one as on Linux. Returns its folder.
fn checkout(progress: &Progress) -> Result<PathBuf> {
    let tree = |name: &str, settings| -> Result<_> {
        let tree = folder().join(name);
        project::remove(&tree)?;
        let mut clone = Command::new("git");
        clone.args(settings).args(["clone", "--quiet"]).arg(project::root()).arg(&tree);
        progress.run(clone)?;
        Ok((project::files(&tree, &[".git"])?, tree))
    };
    let set = |[links, ends]: [&'static str; 2]| ["-c", links, "-c", ends];
    let (windows, tree_of_windows) = tree("windows", set(WINDOWS))?;
    let (linux, _) = tree("linux", set(LINUX))?;
    let other = linux.iter().find(|(path, bytes)| windows.get(*path) != Some(bytes));
    ensure!(
        other.is_none() && windows.len() == linux.len(),
        "{:?}: expected the same bytes on Windows: no symbolic link, and text with LF by .gitattributes",
        other.map(|(path, _)| path)
    );
    Ok(tree_of_windows)
}

/// Runs the tests in the checkout, with a target folder of its own: cargo tells two copies of a package
/// apart by the times of their files alone.
fn tests(tree: &Path, progress: &Progress) -> Result<Tally> {
    let mut test = command::cargo(["test"]);
    test.args(PACKAGES.iter().flat_map(|name| ["--package", name])).current_dir(tree);
    test.env("CARGO_TARGET_DIR", folder().join("target"));
    tally::cargo_test(test, progress)
}
