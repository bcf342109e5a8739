//! `cargo xtask test`: every test; `cargo xtask full`: the long ones, too, on all boards.

use std::process::{Command, ExitCode};

use anyhow::{Context, Result, bail};

use crate::arguments::TestOptions;
use crate::browser::tests::{ALL, Visitor};
use crate::firmware::{Board, board};
use crate::progress::Progress;
use crate::suite::Suite;
use crate::tally::Tally;
use crate::toolchain::Toolchain;
use crate::{command, conform, contributing, demo, effects, firmware, measure, package, site, size};

/// The smallest processor that is promised: no floating point unit, no division, no atomics.
const BARE: &str = "thumbv6m-none-eabi";

/// The sets of luminaire's features that bare metal is promised, as options of cargo.
const FEATURES: [(&str, &[&str]); 4] = [
    ("libm alone", &["--no-default-features", "--features", "libm"]),
    ("micromath alone", &["--no-default-features", "--features", "micromath"]),
    ("its default features", &[]),
    (
        "every feature without std",
        &["--no-default-features", "--features", "arithmetic,fixed,libm,glam,micromath"],
    ),
];

const STD: (&str, &[&str]) = ("std alone", &["--no-default-features", "--features", "std"]);

const NO_VISITOR: &str = "not run, because the demo was not built or no browser started";

/// Runs the tests; the last line on stdout counts them.
pub(crate) fn run(options: TestOptions, full: bool) -> ExitCode {
    let mut suite = Suite::new(options.only);
    suite.side_by_side(|suite| host(suite, full), |suite| boards(suite, full));
    suite.finish()
}

/// What this machine and its browser run.
fn host(suite: &mut Suite, full: bool) {
    sources(suite);
    suite
        .count("host: cargo test", |progress| cargo_test(&["--workspace", "--no-fail-fast"], full, progress));
    // The other sets are tested by `full`; clippy checks all of them.
    for (name, features) in if full { &FEATURES[1..3] } else { &FEATURES[1..2] } {
        suite.count(&format!("host: luminaire with {name}"), |progress| {
            // The long search has been made with all features at once.
            cargo_test(&[&["--package", "luminaire", "--lib"], *features].concat(), false, progress)
        });
    }
    contributing::run(suite, full);
    if full {
        package::run(suite);
    }
    browser(suite);
}

/// What emulated boards run, and the conformance vectors on them, on this machine and in a browser.
fn boards(suite: &mut Suite, full: bool) {
    let boards = board::tested(full);
    bare_metal(suite, full);
    firmware::tests::run(suite, &boards);
    firmware::frame::tests::run(suite, &boards);
    size::tests::run(suite, &boards);
    effects::tests::run(suite);
    prices(suite, &boards);
    conform::tests::run(suite, &boards);
}

fn sources(suite: &mut Suite) {
    suite.step("format: cargo fmt", |progress| {
        progress.run(with(command::cargo("fmt"), &["--all", "--check"]))
    });
    suite.step("lint: cargo clippy", |progress| {
        let clippy = with(command::cargo("clippy"), &["--workspace", "--all-targets"]);
        progress.run(with(clippy, &["--", "-Dwarnings"]))
    });
    for (name, features) in FEATURES.iter().chain([&STD]) {
        suite.step(&format!("lint: luminaire with {name}"), |progress| {
            let clippy = with(command::cargo("clippy"), &["--package", "luminaire", "--lib"]);
            progress.run(with(with(clippy, features), &["--", "-Dwarnings"]))
        });
    }
    suite.step("documentation: cargo doc", |progress| {
        let mut doc = with(command::cargo("doc"), &["--workspace", "--no-deps"]);
        doc.env("RUSTDOCFLAGS", "-Dwarnings");
        progress.run(doc)
    });
}

fn cargo_test(arguments: &[&str], full: bool, progress: &Progress) -> Result<Tally> {
    let mut test = with(command::cargo("test"), arguments);
    if full {
        test.env("LUMINAIRE_FULL", "1");
    }
    let ended = command::capture(test)?;
    progress.quote(&ended.output);
    let mut tally = Tally::of_cargo_test(&ended.output);
    if tally == Tally::default() {
        bail!("no test was run");
    }
    // A test program that does not compile, or that crashes, has no line of its own.
    if !ended.success && tally.failed == 0 {
        tally += Tally::FAILED;
    }
    Ok(tally)
}

/// Checked without code generation: the firmware links the kernel.
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

fn prices(suite: &mut Suite, boards: &[&'static Board]) {
    let name = "prices: errors and instructions are those of the list";
    if suite.wants(name) {
        let targets: Vec<_> = boards.iter().map(|board| measure::Target::Board(board)).collect();
        for remark in suite.require(name, |progress| measure::check(&targets, progress)).unwrap_or_default() {
            println!("    {remark}");
        }
    }
}

fn browser(suite: &mut Suite) {
    let check = "browser: the demo's check";
    let tests = ALL.map(|(name, test)| (format!("browser: {name}"), test));
    if !suite.wants(check) && !tests.iter().any(|(name, _)| suite.wants(name)) {
        return;
    }
    let site = suite.require("browser: the demo is built", site::build);
    let mut visitor = suite.require("browser: the demo is served and Chromium starts", |progress| {
        Visitor::evaluate(site.as_deref().context("there is no demo to serve")?, progress)
    });
    for (name, test) in &tests {
        suite.step(name, |_| test(visitor.as_mut().context(NO_VISITOR)?));
    }
    suite.step(check, |progress| {
        let visitor = visitor.as_mut().context(NO_VISITOR)?;
        progress.say("Checked", demo::check(&mut visitor.chromium, &visitor.address, None)?);
        Ok(())
    });
}

fn with(mut command: Command, arguments: &[&str]) -> Command {
    command.args(arguments);
    command
}
