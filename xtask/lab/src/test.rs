//! `cargo xtask test`, and `cargo xtask full`, which adds the long tests, all boards and all browsers.

use std::fs;
use std::process::{Command, ExitCode};

use anyhow::{Context, Result};

use measure::steps;
use tools::command::cargo;
use tools::demo::site::{self, Build};
use tools::progress::Progress;
use tools::record::Record;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::toolchain::Toolchain;
use tools::{compilers, install, project};

use crate::features::{self, ALL, BARE_METAL, SETS, STD};
use crate::{
    browsers, contributing, eva, fuzz, messages, msrv, package, portable, prove, readers, renderers, scripts,
    semver,
};

/// The packages of tools, with the most dependencies of others. Without `full`, Clippy leaves them out.
const TOOLS: [&str; 5] = ["lab", "luminaire-counter", "measure", "tools", "xtask"];

/// The options of `test`.
#[derive(Debug, PartialEq, clap::Args)]
pub(crate) struct TestOptions {
    /// Run only the steps whose name contains this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
}

/// The options of `full`.
#[derive(Debug, PartialEq, clap::Args)]
pub(crate) struct FullOptions {
    #[command(flatten)]
    test: TestOptions,
    /// Run also the steps that have passed on this very tree
    #[arg(long)]
    again: bool,
}

/// The steps of `full` that have passed, below `target`.
const RECORD: &str = "full.json";

/// Runs the tests; the last line on stdout counts them.
pub(crate) fn run(options: TestOptions) -> ExitCode {
    all(Suite::new(options.only), false)
}

/// Runs all tests, but for the steps that have passed before on this very tree.
pub(crate) fn run_full(FullOptions { test, again }: FullOptions) -> Result<ExitCode> {
    let file = project::target().join(RECORD);
    if again && file.exists() {
        fs::remove_file(&file).context("cannot remove the record of what has passed")?;
    }
    Ok(all(Suite::new(test.only).with_record(Record::read(file)?), true))
}

fn all(mut suite: Suite, full: bool) -> ExitCode {
    // More groups than two processors, because linking keeps only one busy, and groups wait for each other's builds.
    suite.side_by_side([
        Box::new(|suite| host(suite, full)),
        Box::new(|suite| boards(suite, full)),
        Box::new(|suite| {
            page(suite, full);
            if full {
                searches(suite);
            }
        }),
        Box::new(|suite| {
            if full {
                elsewhere(suite)
            }
        }),
        Box::new(|suite| {
            if full {
                packed(suite)
            }
        }),
    ]);
    // After the other steps, because they would slow the page down.
    browsers::visit(&mut suite, full);
    suite.finish()
}

/// Adds the steps that run on this machine.
fn host(suite: &mut Suite, full: bool) {
    sources(suite, full);
    // Without `full`, the packages that a plain `cargo test` takes, without the examples that draw.
    let packages: &[&str] = if full { &["--workspace"] } else { &["--lib", "--bins", "--tests"] };
    suite.count("host: cargo test", |progress| {
        cargo_test(&[packages, &["--no-fail-fast"]].concat(), full, progress)
    });
    if !full {
        // Of the same packages, because another choice would have other features, and be built again.
        suite.count("host: examples in the documentation", |progress| cargo_test(&["--doc"], full, progress));
        suite.count("host: the commands", |progress| cargo_test(&["--package", "xtask"], full, progress));
    }
    // The feature sets whose square root and angles do not come from libm, and the default set. Clippy
    // checks all sets.
    for (name, features) in if full { &SETS[1..4] } else { &[] } {
        suite.count(&format!("host: luminaire with {name}"), |progress| {
            // Without the long searches, which have run with all features at once.
            cargo_test(&[&["--package", "luminaire", "--lib"], *features].concat(), false, progress)
        });
    }
    // Only this step tests the conversions to other crates, and their examples. The other tests have run.
    let (name, features) = ALL;
    let tests: &[&str] = if full { &[] } else { &["interop"] };
    suite.count(&format!("host: luminaire with {name}"), |progress| {
        cargo_test(&[&["--package", "luminaire"], features, tests].concat(), false, progress)
    });
}

/// Adds the long searches. They fill the pauses of other groups: many steps keep one processor busy.
fn searches(suite: &mut Suite) {
    suite.count("host: the long searches", |progress| cargo_test(&["--test", "slow"], true, progress));
}

/// Adds the steps of copies of the tree, and those of other programs and compilers.
fn elsewhere(suite: &mut Suite) {
    contributing::run(suite);
    portable::run(suite);
    readers::run(suite);
    suite.count("export: C compiles for small processors, and has the bits of the kernel", by_all_compilers);
    prove::step(suite);
    eva::step(suite);
    bare_metal(suite);
    dependencies(suite);
    fuzz::step(suite);
    messages::run(suite);
    msrv::run(suite);
    semver::run(suite);
}

/// Adds the steps that run on emulated boards, or build something for one.
fn boards(suite: &mut Suite, full: bool) {
    if full { steps::all_boards(suite) } else { steps::smallest_board(suite) }
}

/// Adds the steps of what is packed, and of the workspace of renderers.
fn packed(suite: &mut Suite) {
    package::run(suite);
    renderers::steps(suite);
}

/// Adds the steps that build the page and check its scripts.
fn page(suite: &mut Suite, full: bool) {
    let build = if full { Build::Small } else { Build::Part };
    suite.step("browser: the demo is built", |progress| site::build(build, progress).map(drop));
    scripts::run(suite, build);
}

/// Checks licences, bans and sources of the dependencies.
fn dependencies(suite: &mut Suite) {
    suite.step("dependencies: licences, bans and sources", |progress| {
        let mut deny = Command::new(install::cargo_program("cargo-deny", progress)?);
        deny.args(["--workspace", "check", "licenses", "bans", "sources"]).current_dir(project::root());
        progress.run(deny)
    });
}

/// Adds the checks that run nothing. With `full`, Clippy also sees each set of features by itself, and
/// cargo all pairs.
fn sources(suite: &mut Suite, full: bool) {
    suite.step("format: cargo fmt", |progress| progress.run(cargo(["fmt", "--all", "--check"])));
    suite.step("lint: cargo clippy", |progress| {
        // All targets are without those that a plain `cargo test` leaves out.
        let mut clippy = cargo(["clippy", "--workspace", "--all-targets", "--test", "slow"]);
        if !full {
            clippy.args(TOOLS.iter().flat_map(|package| ["--exclude", package]));
        }
        clippy.args(["--", "-Dwarnings"]);
        progress.run(clippy)
    });
    if full {
        suite.step("lint: luminaire with each set of features", |progress| {
            SETS.iter().chain([&STD, &ALL]).try_for_each(|(_, features)| {
                let mut clippy = cargo(["clippy", "--package", "luminaire", "--lib", "--tests"]);
                clippy.args(*features).args(["--", "-Dwarnings"]);
                progress.run(clippy)
            })
        });
        suite.step("features: each, all pairs, all and none", |progress| {
            features::pairs(&features::names()?).iter().try_for_each(|set| {
                let check = ["check", "--package", "luminaire", "--no-default-features", "--features", set];
                progress.run(cargo(check))
            })
        });
    }
    let documented: [(&str, &[&str]); 2] = [
        ("luminaire with all features", &["--package", "luminaire", "--all-features"]),
        ("cargo doc", &["--workspace"]),
    ];
    for (name, packages) in &documented[..if full { 2 } else { 1 }] {
        suite.step(&format!("documentation: {name}"), |progress| {
            let mut doc = cargo(["doc", "--no-deps"]);
            doc.args(*packages).env("RUSTDOCFLAGS", "-Dwarnings");
            progress.run(doc)
        });
    }
}

fn cargo_test(arguments: &[&str], full: bool, progress: &Progress) -> Result<Tally> {
    let mut test = cargo(["test"]);
    test.args(arguments).envs(full.then_some(("LUMINAIRE_FULL", "1")));
    tally::cargo_test(test, progress)
}

/// The tests of C with the compilers of all small processors, and the sketches on an emulated AVR; a plain
/// `cargo test` takes what is installed.
fn by_all_compilers(progress: &Progress) -> Result<Tally> {
    compilers::find(progress)?;
    let mut test = cargo(["test", "--package", "luminaire-export"]);
    // The tests skip a compiler that is not installed, unless this variable is set.
    let tests = ["fixed", "float", "spot", "setup", "pixels", "sketches", "library"];
    test.args(tests.map(|test| format!("--test={test}")));
    test.env("LUMINAIRE_TOOLS", "1");
    tally::cargo_test(test, progress)
}

/// Checks the crates for bare metal. No code is generated, because the firmware's steps link the
/// kernel.
fn bare_metal(suite: &mut Suite) {
    let crates =
        SETS.map(|(_, features)| ("luminaire", features)).into_iter().chain([("luminaire-render", &[][..])]);
    suite.step(&format!("bare metal: the crates with each set of features for {BARE_METAL}"), |progress| {
        let toolchain = Toolchain::find(BARE_METAL, progress)?;
        crates.into_iter().try_for_each(|(package, features)| {
            let mut check = toolchain.cargo("core,alloc", ["check", "--lib", "--package", package]);
            check.args(features);
            progress.run(check)
        })
    });
}
