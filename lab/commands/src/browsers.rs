//! The steps of the test run that visit the demo in a browser.

use std::process::Command;

use anyhow::{Context, Result};

use browser::{Chromium, Engine, check::check};
use browser_tests::{LONG, MORE, QUICK, Test, Visit, Visitor, engines};
use tools::demo::site::{self, Build};
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::{install, project};

/// The step whose tests are beside the page, in its language.
const PAGE: &str = "browser: the page";

/// The step that measures the demo.
const CHECK: &str = "browser: the demo's check";

const NO_VISITOR: &str = "not run, because no browser started";

/// The tests of the demo's page.
pub(crate) struct Browsers {
    /// Those in the first engine.
    tests: Vec<(String, Visit)>,
    others: Vec<Elsewhere>,
    /// What of the demo they need.
    build: Build,
}

impl Browsers {
    /// The quick tests in the first engine, or with `full` all that an engine can run, and the long ones in
    /// the first.
    pub(crate) fn new(full: bool) -> Self {
        let more = if full { [&MORE[..], &LONG].concat() } else { Vec::new() };
        let tests = QUICK.iter().chain(&more).map(|(name, test)| (format!("browser: {name}"), *test));
        let [_, others @ ..] = Engine::ALL;
        let others = if full { others.map(Elsewhere::new).into() } else { Vec::new() };
        Self { tests: tests.collect(), others, build: if full { Build::Small } else { Build::Part } }
    }

    fn are_wanted(&self, suite: &Suite) -> bool {
        suite.wants(CHECK)
            || suite.wants(PAGE)
            || self.tests.iter().any(|(name, _)| suite.wants(name))
            || self.others.iter().any(|elsewhere| elsewhere.is_wanted(suite))
    }

    /// Adds the steps. The demo's folder has been built, unless only some steps are run.
    pub(crate) fn visit(&self, suite: &mut Suite) {
        if !self.are_wanted(suite) {
            return;
        }
        if suite.is_selective() {
            suite.require("browser: the demo is built", |progress| site::build(self.build, progress));
        }
        let serve =
            |engine: Engine, progress: &Progress| Visitor::evaluate(engine, &site::folder(), progress);
        let mut visitor = suite.require("browser: the demo is served and Chromium starts", |progress| {
            serve(Engine::Chromium, progress)
        });
        for (name, test) in &self.tests {
            suite.step(name, |_| test(visitor.as_mut().context(NO_VISITOR)?));
        }
        suite.count(PAGE, |progress| page(&visitor.as_ref().context(NO_VISITOR)?.address, progress));
        suite.step(CHECK, |progress| {
            let visitor = visitor.as_mut().context(NO_VISITOR)?;
            progress.say("Checked", check(visitor.browser.as_mut(), &visitor.address, None)?);
            Ok(())
        });
        for elsewhere in &self.others {
            if !elsewhere.is_wanted(suite) {
                continue;
            }
            let start = format!("browser, {}: it starts", elsewhere.engine);
            let mut other = suite.require(&start, |progress| serve(elsewhere.engine, progress));
            for (name, test) in &elsewhere.tests {
                suite.step(name, |progress| {
                    let other = other.as_mut().context(NO_VISITOR)?;
                    test(other).or_else(|error| {
                        // WebKitGTK was seen to crash once in four runs. A page that makes it crash does
                        // so again.
                        if other.browser.revive(progress)? { test(other) } else { Err(error) }
                    })
                });
            }
            suite.step(&elsewhere.alike, |_| {
                engines::draw_alike(
                    visitor.as_mut().context(NO_VISITOR)?,
                    other.as_mut().context(NO_VISITOR)?,
                )
            });
        }
    }
}

/// Tests the page at an address in Chromium.
fn page(address: &str, progress: &Progress) -> Result<Tally> {
    install::npm("puppeteer-core", progress)?;
    let mut test = Command::new(install::node(progress)?);
    test.args(["--test", "browser/page.mjs"]).current_dir(project::root().join("wasm-demo/tests"));
    test.env("PAGE", address).env("MODULES", install::npm_modules());
    test.env("CHROMIUM", Chromium::program(progress)?);
    tally::node_test(test, progress)
}

/// The steps of an engine other than the first.
struct Elsewhere {
    engine: Engine,
    tests: Vec<(String, Visit)>,
    /// The name of the step that compares the engine's pictures with those of the first.
    alike: String,
}

impl Elsewhere {
    fn new(engine: Engine) -> Self {
        let named = |(name, test): &Test| (format!("browser, {engine}: {name}"), *test);
        let tests = engines::tests_of(engine).map(named).collect();
        let alike = format!("browser, {engine}: pictures have the bits of Chromium's");
        Self { engine, tests, alike }
    }

    fn is_wanted(&self, suite: &Suite) -> bool {
        suite.wants(&self.alike) || self.tests.iter().any(|(name, _)| suite.wants(name))
    }
}
