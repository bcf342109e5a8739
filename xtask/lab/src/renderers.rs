//! `cargo xtask renderers`: pictures of renderers that are not the project's.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};

use tools::progress::Progress;
use tools::suite::Suite;
use tools::{command, project};

/// The workspace of the renderers.
pub(crate) const FOLDER: &str = "examples/renderers";

/// The page that has the rows of the table.
const PAGE: &str = "examples/renderers/README.md";

/// Prints the rows of the table of the page.
pub(crate) fn run() -> Result<()> {
    println!("{}", pictures(&project::root().join(FOLDER), &Progress::Live)?.join("\n"));
    Ok(())
}

/// Adds the step: format and lints.
pub(crate) fn steps(suite: &mut Suite) {
    suite.step("renderers: cargo fmt and clippy", |progress| {
        let folder = project::root().join(FOLDER);
        progress.run(cargo(&folder, &["fmt", "--all", "--check"]))?;
        progress.run(cargo(&folder, &["clippy", "--workspace", "--all-targets", "--", "-Dwarnings"]))
    });
}

/// Draws all pictures and compares them, in a folder that holds the workspace. Returns a row of the table
/// for each renderer.
pub(crate) fn pictures(folder: &Path, progress: &Progress) -> Result<Vec<String>> {
    let output = progress.output(cargo(folder, &["test", "--workspace", "--", "--nocapture"]))?;
    let rows = output.lines().filter(|line| line.starts_with("| "));
    Ok(rows.map(str::to_owned).collect())
}

/// Fails unless the page has these rows.
pub(crate) fn are_on_the_page(rows: &[String]) -> Result<()> {
    let page = fs::read_to_string(project::root().join(PAGE)).context(PAGE)?;
    ensure!(!rows.is_empty(), "expected rows");
    let missing: Vec<_> = rows.iter().filter(|row| !page.contains(*row)).collect();
    ensure!(missing.is_empty(), "{PAGE} has other rows than `cargo xtask renderers` prints: {missing:#?}");
    Ok(())
}

/// A call of cargo in a workspace of renderers, whose crates are compiled in a folder of their own.
fn cargo(folder: &Path, words: &[&str]) -> Command {
    let mut cargo = command::cargo(words);
    cargo.current_dir(folder).env("CARGO_TARGET_DIR", project::target().join("renderers"));
    cargo
}
