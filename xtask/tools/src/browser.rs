//! Pages in a headless Chromium. [Scripts](../../browser) drive the browser by puppeteer-core; the [tests of the
//! page](../../../wasm-demo/tests/browser) start it the same way.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use anyhow::{Context, Result, bail, ensure};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::progress::Progress;
use crate::tool::{self, Tool};
use crate::{command, family, install, project};

/// Node.js for a script that drives browsers by puppeteer-core, with what it reads of its environment.
/// Installs what is missing: the npm packages, and as root on Debian the browser.
pub fn node(progress: &Progress) -> Result<Command> {
    install::npm("puppeteer-core", progress)?;
    let mut node = Command::new(install::program(&tool::NODE, progress)?);
    let chromium = find("CHROME", &tool::CHROMIUM, progress)?;
    node.env("MODULES", install::npm_modules()).env("CHROMIUM", chromium);
    // Below `target`, because a sandboxed browser may have no access to `/tmp`.
    let folder = project::target().join("browsers");
    fs::create_dir_all(&folder)?;
    node.env("TMPDIR", folder);
    Ok(node)
}

/// The program that an environment variable names, or that of a tool. As root on Debian, installs the
/// tool if it is missing.
pub fn find(variable: &str, tool: &Tool, progress: &Progress) -> Result<PathBuf> {
    if let Some(named) = env::var_os(variable) {
        ensure!(Path::new(&named).is_file(), "{variable} = {}: expected a program", named.display());
        return Ok(named.into());
    }
    install::program(tool, progress)
        .with_context(|| format!("the environment variable {variable} may name the program"))
}

/// Runs a page of the demo once in Chromium, and writes a picture of it. Returns its measurements as
/// one line.
pub fn check(address: &str, picture: Option<&Path>, progress: &Progress) -> Result<String> {
    let mut node = node(progress)?;
    node.arg(project::root().join("xtask/browser/check.mjs")).arg(address).args(picture);
    progress.timed("Checking", address, || command::answer(&mut node))
}

/// What draws the WebGL of pages on a machine without a GPU.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum WebGl {
    /// SwiftShader, which is a part of Chromium.
    SwiftShader,
    /// llvmpipe, which is a part of Mesa.
    Llvmpipe,
}

/// Lets Chromium draw without a GPU, as on a machine that has none.
const NO_GPU: &str = "--disable-gpu";

/// Lets Chromium draw by Mesa's OpenGL, on an X display.
const MESA: [&str; 4] =
    ["--ozone-platform=x11", "--use-gl=angle", "--use-angle=gl", "--ignore-gpu-blocklist"];

/// A page to open.
#[derive(Clone, Copy, Debug, Default)]
pub struct Visit<'a> {
    /// Its address.
    pub address: &'a str,
    /// What draws its WebGL, if it has any.
    pub web_gl: Option<WebGl>,
}

/// What a visit has found.
#[derive(Clone, Debug, Deserialize)]
pub struct Found {
    /// The browser's name and version.
    pub version: String,
    /// The value of each expression.
    pub values: Vec<Value>,
}

impl Visit<'_> {
    /// Opens the page, waits until it is ready, and evaluates JavaScript expressions in it; a promise
    /// is awaited. It is an error if the page complains on its console.
    pub fn run(&self, expressions: &[String], progress: &Progress) -> Result<Found> {
        let is_mesa = self.web_gl == Some(WebGl::Llvmpipe);
        let mut flags = if is_mesa { MESA.to_vec() } else { vec![NO_GPU] };
        flags.extend((self.web_gl == Some(WebGl::SwiftShader)).then_some("--enable-unsafe-swiftshader"));
        let acts: Vec<_> = expressions.iter().map(|expression| json!({ "ask": expression })).collect();
        let request = json!({ "address": self.address, "flags": flags, "display": is_mesa, "acts": acts });
        let mut node = node(progress)?;
        if is_mesa {
            node.env("XVFB", find("XVFB", &tool::XVFB, progress)?);
        }
        node.arg(project::root().join("xtask/browser/drive.mjs"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped());
        let mut program = family::start(node.stderr(Stdio::piped())).context("cannot start node")?;
        program
            .child
            .stdin
            .take()
            .context("node takes no input")?
            .write_all(request.to_string().as_bytes())?;
        let ended = command::told(program)?;
        if !ended.status.success() {
            bail!("{}: {}", self.address, String::from_utf8_lossy(&ended.stderr).trim());
        }
        serde_json::from_slice(&ended.stdout).context("the browser's script has not printed JSON")
    }

    /// The value of a single expression in the page.
    pub fn ask(&self, expression: &str, progress: &Progress) -> Result<Value> {
        let mut found = self.run(&[expression.to_owned()], progress)?;
        found.values.pop().context("the page has no answer")
    }
}
