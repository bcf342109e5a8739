//! `cargo xtask test` and `cargo xtask full`, which adds the long tests and all boards.

use std::iter;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use anyhow::{Context, Result};
use serde_json::Value;

use crate::arguments::TestOptions;
use browser_tests::{LONG, MORE, QUICK, Test, Visit, Visitor, engines};
use measure::boards::{self, Board};
use measure::{c, conform, device, effects, frame, pick, prices, size};
use tools::browser::Engine;
use tools::demo::site;
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::toolchain::Toolchain;
use tools::{command, install, project};

use crate::{contributing, demo, export, msrv, package, renderers, scripts, semver};

/// The smallest processor that is supported: it has no floating point unit, no division and no
/// atomics.
const BARE: &str = "thumbv6m-none-eabi";

/// The sets of luminaire's features that are supported on bare metal, as options of cargo.
const FEATURES: [(&str, &[&str]); 5] = [
    ("libm alone", &["--no-default-features", "--features", "libm"]),
    ("micromath alone", &["--no-default-features", "--features", "micromath"]),
    ("fixed alone", &["--no-default-features", "--features", "fixed"]),
    ("its default features", &[]),
    (
        "every feature without std",
        &[
            "--no-default-features",
            "--features",
            "arithmetic,bytemuck,defmt,embedded-graphics-core,fixed,glam,libm,micromath,mint,serde",
        ],
    ),
];

const STD: (&str, &[&str]) = ("std alone", &["--no-default-features", "--features", "std"]);

const ALL_FEATURES: (&str, &[&str]) = ("all features", &["--all-features"]);

/// The step that measures the demo.
const CHECK: &str = "browser: the demo's check";

const NO_VISITOR: &str = "not run, because the demo was not built or no browser started";

/// Runs the tests; the last line on stdout counts them.
pub(crate) fn run(options: TestOptions, full: bool) -> ExitCode {
    let mut suite = Suite::new(options.only);
    let browsers = Browsers::new(full);
    let mut site = None;
    // Three groups for two processors: the modules of the demo are linked by one.
    suite.side_by_side([
        Box::new(|suite| host(suite, full)),
        Box::new(|suite| boards(suite, full)),
        Box::new(|suite| {
            scripts::run(suite);
            site = browsers.build(suite);
            export::run(suite);
        }),
    ]);
    // After all else: a page that waits for a processor is tested slowly.
    browsers.visit(&mut suite, site.as_deref());
    suite.finish()
}

/// Adds the steps that run on this machine.
fn host(suite: &mut Suite, full: bool) {
    sources(suite, full);
    suite
        .count("host: cargo test", |progress| cargo_test(&["--workspace", "--no-fail-fast"], full, progress));
    // The feature sets whose square root and angles do not come from libm, and with `full` the
    // default set. Clippy checks all sets.
    for (name, features) in if full { &FEATURES[1..4] } else { &FEATURES[1..3] } {
        suite.count(&format!("host: luminaire with {name}"), |progress| {
            // Without the long searches, which have run with all features at once.
            cargo_test(&[&["--package", "luminaire", "--lib"], *features].concat(), false, progress)
        });
    }
    // Only this step tests the conversions to other crates, and their examples.
    let (name, features) = ALL_FEATURES;
    suite.count(&format!("host: luminaire with {name}"), |progress| {
        cargo_test(&[&["--package", "luminaire"], features].concat(), false, progress)
    });
    if full {
        contributing::run(suite);
        dependencies(suite);
        fuzz(suite);
        msrv::run(suite);
        package::run(suite);
        semver::run(suite);
    }
}

/// Checks that the fuzzer's targets compile. They belong to another workspace, and only the fuzzer
/// runs them.
fn fuzz(suite: &mut Suite) {
    suite.step("fuzz: the targets compile", |progress| {
        let mut check = with(command::cargo("check"), &["--bins"]);
        check.current_dir(project::root().join("fuzz"));
        progress.run(check)
    });
}

/// Checks licences, bans and sources of the dependencies.
fn dependencies(suite: &mut Suite) {
    suite.step("dependencies: licences, bans and sources", |progress| {
        let mut deny = Command::new(install::cargo_program("cargo-deny", progress)?);
        deny.args(["--workspace", "check", "licenses", "bans", "sources"]).current_dir(project::root());
        progress.run(deny)
    });
}

/// Adds the steps that run on emulated boards, and the conformance vectors on boards, this machine
/// and a browser.
fn boards(suite: &mut Suite, full: bool) {
    let boards = boards::tested(full);
    bare_metal(suite, full);
    boards::steps::run(suite, &boards);
    frame::steps::run(suite, &boards, full);
    size::steps::run(suite, &boards, full);
    effects::steps::run(suite, full);
    if full {
        pick::steps(suite, &boards);
        c::steps(suite, &boards);
        renderers::steps(suite);
        device::steps::run(suite);
    }
    prices(suite, &boards, full);
    conform::steps::run(suite, &boards);
}

fn sources(suite: &mut Suite, full: bool) {
    suite.step("format: cargo fmt", |progress| {
        progress.run(with(command::cargo("fmt"), &["--all", "--check"]))
    });
    suite.step("lint: cargo clippy", |progress| {
        let clippy = with(command::cargo("clippy"), &["--workspace", "--all-targets"]);
        progress.run(with(clippy, &["--", "-Dwarnings"]))
    });
    let linted = if full { &FEATURES[..] } else { &FEATURES[4..] };
    for (name, features) in linted.iter().chain([&STD, &ALL_FEATURES]) {
        suite.step(&format!("lint: luminaire with {name}"), |progress| {
            let clippy = with(command::cargo("clippy"), &["--package", "luminaire", "--lib", "--tests"]);
            progress.run(with(with(clippy, features), &["--", "-Dwarnings"]))
        });
    }
    if full {
        suite.step("features: each, all pairs, all and none", |progress| {
            let features = features_of_luminaire()?;
            sets(&features).iter().try_for_each(|set| {
                let check =
                    with(command::cargo("check"), &["--package", "luminaire", "--no-default-features"]);
                progress.run(with(check, &["--features", set]))
            })
        });
    }
    let documented: [(&str, &[&str]); 2] = [
        ("cargo doc", &["--workspace", "--no-deps"]),
        ("luminaire with all features", &["--package", "luminaire", "--all-features", "--no-deps"]),
    ];
    for (name, arguments) in documented {
        suite.step(&format!("documentation: {name}"), |progress| {
            let mut doc = with(command::cargo("doc"), arguments);
            doc.env("RUSTDOCFLAGS", "-Dwarnings");
            progress.run(doc)
        });
    }
}

/// The features that luminaire's manifest names, without `default`, which only selects others.
pub(crate) fn features_of_luminaire() -> Result<Vec<String>> {
    let metadata =
        command::answer(&mut with(command::cargo("metadata"), &["--no-deps", "--format-version", "1"]))?;
    let metadata: Value = serde_json::from_str(&metadata).context("cargo metadata is no JSON")?;
    let mut packages = metadata["packages"].as_array().into_iter().flatten();
    let luminaire = packages.find(|package| package["name"] == "luminaire");
    let features = luminaire.and_then(|package| package["features"].as_object());
    let names = features.context("cargo metadata has no features of luminaire")?.keys();
    Ok(names.filter(|name| *name != "default").cloned().collect())
}

/// Sets of features as options of cargo: none, each alone, each pair, and all.
fn sets(features: &[String]) -> Vec<String> {
    let alone = features.iter().cloned();
    let pairs = features
        .iter()
        .enumerate()
        .flat_map(|(i, first)| features[i + 1..].iter().map(move |second| format!("{first},{second}")));
    iter::once(String::new()).chain(alone).chain(pairs).chain([features.join(",")]).collect()
}

fn cargo_test(arguments: &[&str], full: bool, progress: &Progress) -> Result<Tally> {
    let mut test = with(command::cargo("test"), arguments);
    if full {
        test.env("LUMINAIRE_FULL", "1");
    }
    tally::cargo_test(test, progress)
}

/// Checks the crates for bare metal. No code is generated, because the firmware's steps link the
/// kernel.
fn bare_metal(suite: &mut Suite, full: bool) {
    let check = |progress: &Progress, package: &str, features: &[&str]| {
        let toolchain = Toolchain::find(BARE, progress)?;
        let cargo = with(toolchain.cargo_check("core,alloc"), &["--lib", "--package", package]);
        progress.run(with(cargo, features))
    };
    for (name, features) in if full { &FEATURES[..] } else { &FEATURES[1..2] } {
        suite.step(&format!("bare metal: luminaire with {name} for {BARE}"), |progress| {
            check(progress, "luminaire", features)
        });
    }
    suite.step(&format!("bare metal: luminaire-render for {BARE}"), |progress| {
        check(progress, "luminaire-render", &[])
    });
}

fn prices(suite: &mut Suite, boards: &[&'static Board], full: bool) {
    suite.remarked("prices: errors and instructions are those of the list", |progress| {
        let targets: Vec<_> = boards.iter().map(|board| prices::Target::Board(board)).collect();
        prices::check(&targets, full, progress)
    });
}

/// The tests of the demo's page that are wanted.
struct Browsers {
    /// Those in the first engine.
    tests: Vec<(String, Visit)>,
    others: Vec<Elsewhere>,
}

impl Browsers {
    /// The quick tests in every engine, or with `full` all that an engine can run, and the long ones in
    /// the first.
    fn new(full: bool) -> Self {
        let more = if full { [&MORE[..], &LONG].concat() } else { Vec::new() };
        let tests = QUICK.iter().chain(&more).map(|(name, test)| (format!("browser: {name}"), *test));
        let [_, others @ ..] = Engine::ALL;
        Self { tests: tests.collect(), others: others.map(|engine| Elsewhere::new(engine, full)).into() }
    }

    fn are_wanted(&self, suite: &Suite) -> bool {
        suite.wants(CHECK)
            || self.tests.iter().any(|(name, _)| suite.wants(name))
            || self.others.iter().any(|elsewhere| elsewhere.is_wanted(suite))
    }

    /// Builds the demo, if a test needs it. Returns its folder.
    fn build(&self, suite: &mut Suite) -> Option<PathBuf> {
        if self.are_wanted(suite) { suite.require("browser: the demo is built", site::build) } else { None }
    }

    /// Adds the steps that need the demo's folder.
    fn visit(&self, suite: &mut Suite, site: Option<&Path>) {
        if !self.are_wanted(suite) {
            return;
        }
        let serve = |engine: Engine, progress: &Progress| {
            Visitor::evaluate(engine, site.context("there is no demo to serve")?, progress)
        };
        let mut visitor = suite.require("browser: the demo is served and Chromium starts", |progress| {
            serve(Engine::Chromium, progress)
        });
        for (name, test) in &self.tests {
            suite.step(name, |_| test(visitor.as_mut().context(NO_VISITOR)?));
        }
        suite.step(CHECK, |progress| {
            let visitor = visitor.as_mut().context(NO_VISITOR)?;
            progress.say("Checked", demo::check(visitor.browser.as_mut(), &visitor.address, None)?);
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
                        // WebKitGTK crashes once in hundreds of pages. A page that makes it crash does so
                        // again.
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

/// The steps of an engine other than the first.
struct Elsewhere {
    engine: Engine,
    tests: Vec<(String, Visit)>,
    /// The name of the step that compares the engine's pictures with those of the first.
    alike: String,
}

impl Elsewhere {
    fn new(engine: Engine, full: bool) -> Self {
        let named = |(name, test): &Test| (format!("browser, {engine}: {name}"), *test);
        let mut tests: Vec<_> = engines::SMOKE.iter().map(named).collect();
        if full {
            let all = engines::tests_of(engine).map(named);
            let more: Vec<_> = all.filter(|(name, _)| tests.iter().all(|(quick, _)| quick != name)).collect();
            tests.extend(more);
        }
        let alike = format!("browser, {engine}: pictures have the bits of Chromium's");
        Self { engine, tests, alike }
    }

    fn is_wanted(&self, suite: &Suite) -> bool {
        suite.wants(&self.alike) || self.tests.iter().any(|(name, _)| suite.wants(name))
    }
}

fn with(mut command: Command, arguments: &[&str]) -> Command {
    command.args(arguments);
    command
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_none_each_each_pair_and_all() {
        let sets = sets(&["a", "b", "c"].map(str::to_owned));
        assert_eq!(sets, ["", "a", "b", "c", "a,b", "a,c", "b,c", "a,b,c"]);
    }

    #[test]
    fn bare_metal_is_promised_every_feature_but_std() {
        let mut features = features_of_luminaire().unwrap();
        features.retain(|feature| feature != "std");
        assert_eq!(FEATURES.last().unwrap().1[2], features.join(","));
    }
}
