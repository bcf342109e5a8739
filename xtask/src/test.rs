//! `cargo xtask test` and `cargo xtask full`, which adds the long tests and all boards.

use std::iter;
use std::process::{Command, ExitCode};

use anyhow::{Context, Result};
use serde_json::Value;

use crate::arguments::TestOptions;
use measure::boards::{self, Board};
use measure::{c, conform, device, effects, frame, pick, prices, size};
use tools::progress::Progress;
use tools::suite::Suite;
use tools::tally::{self, Tally};
use tools::toolchain::Toolchain;
use tools::{command, install, project};

use crate::browsers::Browsers;
use crate::{contributing, export, msrv, package, renderers, scripts, semver};

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

/// Runs the tests; the last line on stdout counts them.
pub(crate) fn run(options: TestOptions, full: bool) -> ExitCode {
    let mut suite = Suite::new(options.only);
    let browsers = Browsers::new(full);
    let mut site = None;
    // Three groups for two processors, because linking the demo's modules keeps only one busy.
    suite.side_by_side([
        Box::new(|suite| host(suite, full)),
        Box::new(|suite| boards(suite, full)),
        Box::new(|suite| {
            scripts::run(suite);
            site = browsers.build(suite);
            export::run(suite);
        }),
    ]);
    // After the other steps, because they would slow the page down.
    browsers.visit(&mut suite, site.as_deref());
    suite.finish()
}

/// Adds the steps that run on this machine.
fn host(suite: &mut Suite, full: bool) {
    sources(suite, full);
    suite
        .count("host: cargo test", |progress| cargo_test(&["--workspace", "--no-fail-fast"], full, progress));
    // The feature sets whose square root and angles do not come from libm, and with `full` the
    // default set. With `full`, Clippy checks all sets.
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
