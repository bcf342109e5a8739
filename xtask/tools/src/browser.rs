//! Programs that drive browsers.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use anyhow::{Context, Result, ensure};

use crate::progress::Progress;
use crate::{command, install, project};

/// Node.js for a script that drives browsers by puppeteer-core, with what it reads of its environment.
/// Installs what is missing: the npm packages, and as root on Debian the browser.
pub fn node(progress: &Progress) -> Result<Command> {
    install::npm("puppeteer-core", progress)?;
    let mut node = Command::new(install::node(progress)?);
    let chromium =
        find("CHROME", &["chromium", "chromium-browser", "google-chrome"], &["chromium"], progress)?;
    node.env("MODULES", install::npm_modules()).env("CHROMIUM", chromium);
    // Below `target`, because a sandboxed browser may have no access to `/tmp`.
    let folder = project::target().join("browsers");
    fs::create_dir_all(&folder)?;
    node.env("TMPDIR", folder);
    Ok(node)
}

/// The program that an environment variable names, or the first of these programs on PATH. As root
/// on Debian, installs the packages if there is none.
pub fn find(variable: &str, names: &[&str], packages: &[&str], progress: &Progress) -> Result<PathBuf> {
    if let Some(named) = env::var_os(variable) {
        ensure!(Path::new(&named).is_file(), "{variable} = {}: expected a program", named.display());
        return Ok(named.into());
    }
    install::program(names, packages, progress)
        .with_context(|| format!("the environment variable {variable} may name the program"))
}

/// Runs a page of the demo once in Chromium, and writes a picture of it. Returns its measurements as
/// one line.
pub fn check(address: &str, picture: Option<&Path>, progress: &Progress) -> Result<String> {
    let step = progress.begin("Checking", address);
    let mut node = node(progress)?;
    node.arg(project::root().join("xtask/browser/check.mjs")).arg(address).args(picture);
    let verdict = command::answer(&mut node)?;
    step.done();
    Ok(verdict)
}
