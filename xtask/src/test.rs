//! `cargo xtask test`, and `cargo xtask full`, which adds the long tests, all boards and all browsers.

use std::process::{Command, ExitCode};

use anyhow::Result;

use tools::demo::site::{self, Build};
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::toolchain::Toolchain;
use tools::{command, compilers, install, project};

use crate::features::{ALL, BARE_METAL, SETS, STD};
use crate::{contributing, features, lab, msrv, scripts, semver};

/// The packages of tools, with the most dependencies of others. Without `full`, Clippy leaves them out.
const TOOLS: [&str; 5] = ["lab", "luminaire-counter", "measure", "tools", "xtask"];

/// How the names of steps begin that are of this program alone: they run without the laboratory.
const OWN: [&str; 13] = [
    "bare metal",
    "contributing",
    "dependencies",
    "documentation",
    "export: C",
    "features",
    "format",
    "fuzz",
    "host",
    "lint",
    "oldest compiler",
    "scripts",
    "semver",
];

/// Runs the tests; the last line on stdout counts them.
pub(crate) fn run(only: Option<String>, full: bool) -> ExitCode {
    let mut suite = Suite::new(only.clone());
    let is_own = only.as_ref().is_some_and(|text| OWN.iter().any(|own| text.starts_with(own)));
    if !is_own {
        // First, because cargo builds one thing at a time in a folder, and the others have long steps.
        suite.require("the laboratory is built", lab::build);
    }
    let laboratory = |suite: &mut Suite, part: &str| {
        if is_own {
            return;
        }
        let mut steps = lab::program();
        steps.args(["steps", part]).args(full.then_some("--full"));
        steps.args(only.iter().flat_map(|text| ["--only", text]));
        suite.run_elsewhere(steps);
    };
    // Three groups for two processors, because linking the demo's modules keeps only one busy.
    suite.side_by_side([
        Box::new(|suite| host(suite, full)),
        Box::new(|suite| laboratory(suite, "boards")),
        Box::new(|suite| page(suite, full)),
    ]);
    // After the other steps, because they would slow the page down.
    laboratory(&mut suite, "browsers");
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
    if full {
        suite.count("host: the long searches", |progress| cargo_test(&["--test", "slow"], full, progress));
    } else {
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
    // Only this step tests the conversions to other crates, and their examples.
    let (name, features) = ALL;
    suite.count(&format!("host: luminaire with {name}"), |progress| {
        cargo_test(&[&["--package", "luminaire"], features].concat(), false, progress)
    });
    if full {
        suite.count(
            "export: C compiles for small processors, and has the bits of the kernel",
            by_all_compilers,
        );
        bare_metal(suite);
        contributing::run(suite);
        dependencies(suite);
        fuzz(suite);
        msrv::run(suite);
        semver::run(suite);
    }
}

/// Adds the steps that build the page and check its scripts.
fn page(suite: &mut Suite, full: bool) {
    let build = if full { Build::Small } else { Build::Part };
    suite.step("browser: the demo is built", |progress| site::build(build, progress).map(drop));
    scripts::run(suite);
}

/// Checks that the fuzzer's targets compile. They belong to another workspace, and only the fuzzer
/// runs them.
fn fuzz(suite: &mut Suite) {
    suite.step("fuzz: the targets compile", |progress| {
        let mut check = with(command::cargo("check"), &["--bins"]);
        check.current_dir(project::root().join("tests/fuzz"));
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

/// Adds the checks that run nothing. With `full`, Clippy also sees each set of features by itself, and
/// cargo all pairs.
fn sources(suite: &mut Suite, full: bool) {
    suite.step("format: cargo fmt", |progress| {
        progress.run(with(command::cargo("fmt"), &["--all", "--check"]))
    });
    suite.step("lint: cargo clippy", |progress| {
        // All targets are without those that a plain `cargo test` leaves out.
        let all = ["--workspace", "--all-targets", "--test", "slow"];
        let mut clippy = with(command::cargo("clippy"), &all);
        if !full {
            clippy.args(TOOLS.iter().flat_map(|package| ["--exclude", package]));
        }
        progress.run(with(clippy, &["--", "-Dwarnings"]))
    });
    if full {
        suite.step("lint: luminaire with each set of features", |progress| {
            SETS.iter().chain([&STD, &ALL]).try_for_each(|(_, features)| {
                let clippy = with(command::cargo("clippy"), &["--package", "luminaire", "--lib", "--tests"]);
                progress.run(with(with(clippy, features), &["--", "-Dwarnings"]))
            })
        });
        suite.step("features: each, all pairs, all and none", |progress| {
            features::pairs(&features::names()?).iter().try_for_each(|set| {
                let check =
                    with(command::cargo("check"), &["--package", "luminaire", "--no-default-features"]);
                progress.run(with(check, &["--features", set]))
            })
        });
    }
    let documented: [(&str, &[&str]); 2] = [
        ("luminaire with all features", &["--package", "luminaire", "--all-features", "--no-deps"]),
        ("cargo doc", &["--workspace", "--no-deps"]),
    ];
    for (name, arguments) in &documented[..if full { 2 } else { 1 }] {
        suite.step(&format!("documentation: {name}"), |progress| {
            let mut doc = with(command::cargo("doc"), arguments);
            doc.env("RUSTDOCFLAGS", "-Dwarnings");
            progress.run(doc)
        });
    }
}

fn cargo_test(arguments: &[&str], full: bool, progress: &Progress) -> Result<Tally> {
    let mut test = with(command::cargo("test"), arguments);
    if full {
        test.env("LUMINAIRE_FULL", "1");
    }
    tally::cargo_test(test, progress)
}

/// The tests of C with the compilers of all small processors; a plain `cargo test` takes those that are
/// installed.
fn by_all_compilers(progress: &Progress) -> Result<Tally> {
    compilers::find(progress)?;
    let mut test = command::cargo("test");
    // The tests skip a compiler that is not installed, unless this variable is set.
    test.args(["--package", "luminaire-export", "--test", "fixed", "--test", "float"])
        .args(["--package", "luminaire-c", "--test", "calls"])
        .env("LUMINAIRE_TOOLS", "1");
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
            let cargo = with(toolchain.cargo_check("core,alloc"), &["--lib", "--package", package]);
            progress.run(with(cargo, features))
        })
    });
}

fn with(mut command: Command, arguments: &[&str]) -> Command {
    command.args(arguments);
    command
}
