//! The steps of the test run that visit the demo in a browser.

use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::sync::{Mutex, PoisonError};

use anyhow::{Context, Result, ensure};
use serde_json::{Value, json};
use tempfile::TempDir;

use tools::browser::{self, check, find};
use tools::demo::publish::publish;
use tools::demo::site::{self, Build};
use tools::progress::Progress;
use tools::server::{self, Server};
use tools::suite::Suite;
use tools::system::System;
use tools::tally::{self, Tally};
use tools::{command, install, project, tool};

use crate::expected;

/// The files of the page's tests in `wasm-demo/tests/browser`: one for each kind of promise, the longest first.
const TESTS: [&str; 8] = ["stage", "lights", "page", "failure", "workers", "access", "files", "views"];

/// The test of every engine but the first.
const ENGINES: &str = "engines";

/// The step that times the page's pictures.
const CHECK: &str = "browser: the demo's check";

const SHADERS: &str = "export: shaders draw what the kernel computes";

const NOT_SERVED: &str = "not run, because the demo is not served";

/// The path under which the folder for static hosts is served, and the address that it is written for.
const PATH: &str = "some/where/";
const STANDS: &str = "https://example.org/demo/";
const SOURCE: &str = "https://example.org/source/";

/// Debian's interpreter, whose packages WebKitGTK needs, and a program that succeeds if it can run WebKitGTK.
const PYTHON: &str = "/usr/bin/python3";
const HAS_WEBKIT: &str = "import gi; gi.require_version('WebKit2', '4.1')";

/// A browser engine, as the tests call it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Engine {
    Chromium,
    Firefox,
    WebKit,
}

impl Engine {
    /// The name of the step of a file.
    fn step(self, file: &str) -> String {
        let engine = if self == Self::Chromium { "" } else { &format!(", {self:?}") };
        format!("browser{engine}: {file}")
    }
}

/// Adds the steps. The demo's folder has been built, unless only some steps are run.
pub(crate) fn visit(suite: &mut Suite, full: bool) {
    suite.remarked(SHADERS, shaders);
    let mut steps = TESTS.map(|file| (Engine::Chromium, file)).to_vec();
    if full {
        steps.extend(TESTS.iter().chain([&ENGINES]).map(|file| (Engine::Firefox, *file)));
        steps.push((Engine::WebKit, ENGINES));
    }
    let (steps, others): (Vec<_>, Vec<_>) =
        steps.into_iter().partition(|(engine, file)| suite.wants(&engine.step(file)));
    others.iter().for_each(|(engine, file)| suite.skip(&engine.step(file)));
    if steps.is_empty() && !suite.wants(CHECK) {
        suite.skip(CHECK);
        return;
    }
    let build = if full { Build::Small } else { Build::Part };
    if suite.is_selective() {
        suite.require("browser: the demo is built", |progress| site::build(build, progress));
    }
    let served = suite.require("browser: the demo is served", |progress| Served::new(build, progress));
    // Two at a time, because a page waits most of the time: for pictures, and for what a visitor does.
    let (served, steps) = (&served, &Mutex::new(steps.into_iter()));
    let next = || steps.lock().unwrap_or_else(PoisonError::into_inner).next();
    let visit = |suite: &mut Suite| {
        while let Some((engine, file)) = next() {
            suite.count(&engine.step(file), |progress| {
                test(engine, file, full, served.as_ref().context(NOT_SERVED)?, progress)
            });
        }
    };
    suite.side_by_side([Box::new(visit), Box::new(visit)]);
    suite.step(CHECK, |progress| {
        let address = served.as_ref().context(NOT_SERVED)?.demo.address();
        progress.say("Checked", check(&address, None, progress)?);
        Ok(())
    });
}

/// The demo on its own server and, for static hosts, under a path of a plain one.
struct Served {
    demo: Server,
    /// The file of what the tests expect.
    expected: PathBuf,
    _host: (Server, TempDir),
}

impl Served {
    fn new(build: Build, progress: &Progress) -> Result<Self> {
        let demo = Server::start(&site::folder(build))?;
        let host = tempfile::tempdir()?;
        let folder = host.path().join(PATH);
        let first = publish(&site::folder(build), &folder, [Some(STANDS), Some(SOURCE)], progress)?;
        let plain = Server::on(server::listen(0)?, "", host.path())?;
        let mut expected = expected::page(build)?;
        expected["hosted"] = json!({
            "address": format!("{}{PATH}", plain.address()), "folder": folder, "stands": STANDS,
            "files": first, "isSmall": build == Build::Small,
        });
        Ok(Self { demo, expected: write("page", &expected)?, _host: (plain, host) })
    }
}

/// Writes what tests expect. Returns the file.
fn write(name: &str, expected: &Value) -> Result<PathBuf> {
    let file = project::target().join(format!("expected-{name}.json"));
    fs::write(&file, expected.to_string()).with_context(|| format!("cannot write {}", file.display()))?;
    Ok(file)
}

/// Node.js with the tests of a file.
fn node(file: &str, expected: PathBuf, progress: &Progress) -> Result<Command> {
    let mut node = browser::node(progress)?;
    node.args(["--test", &format!("wasm-demo/tests/browser/{file}.mjs")]).current_dir(project::root());
    node.env("EXPECTED", expected);
    Ok(node)
}

/// Runs the tests of a file in an engine.
fn test(engine: Engine, file: &str, full: bool, served: &Served, progress: &Progress) -> Result<Tally> {
    let mut node = node(file, served.expected.clone(), progress)?;
    // The long tests are of the first engine.
    let level = match (full, engine) {
        (false, _) => "quick",
        (true, Engine::Chromium) => "long",
        (true, _) => "more",
    };
    node.env("PAGE", served.demo.address()).env("ENGINE", format!("{engine:?}")).env("LEVEL", level);
    match engine {
        Engine::Chromium => {
            install::npm("axe-core", progress)?;
        }
        Engine::Firefox => {
            node.env("FIREFOX", find("FIREFOX", &tool::FIREFOX, progress)?);
        }
        Engine::WebKit => webkit(&mut node, progress)?,
    }
    tally::node_test(node, progress)
}

/// Names the programs that WebKitGTK needs. As root on Debian, installs them.
fn webkit(node: &mut Command, progress: &Progress) -> Result<()> {
    let has_webkit = || command::answer(Command::new(PYTHON).args(["-c", HAS_WEBKIT])).is_ok();
    if !has_webkit() && install::debian_root() {
        install::apt(tool::WEBKIT.debian, progress)?;
    }
    ensure!(has_webkit(), "{PYTHON} has no WebKitGTK: {}", tool::remedy(&[&tool::WEBKIT], System::HERE));
    node.env("PYTHON", PYTHON).env("XVFB", find("XVFB", &tool::XVFB, progress)?);
    node.env("WEBKIT_DRIVER", find("WEBKIT_DRIVER", &tool::WEBKIT, progress)?);
    Ok(())
}

/// What `luminaire export` writes as a shader, drawn by Chromium. Returns the differences in words.
fn shaders(progress: &Progress) -> Result<Vec<String>> {
    let output = progress.output(node("shaders", write("shaders", &expected::shaders()?)?, progress)?)?;
    let told = output.lines().filter(|line| line.contains(" places, "));
    Ok(told.map(|line| line.trim_start_matches("# ").to_owned()).collect())
}
