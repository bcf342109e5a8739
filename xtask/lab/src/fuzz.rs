//! The fuzzer's targets of `tests/fuzz`. libFuzzer is compiled by their build, and stable Rust counts the edges that an
//! input covers by a pass of LLVM, as `cargo fuzz` does with a nightly compiler.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result};
use tools::command::cargo;
use tools::progress::Progress;
use tools::suite::Suite;
use tools::{install, project, tool};

/// A target by its name, with the largest input in bytes, and folders of inputs to begin with.
type Target = (&'static str, u32, &'static [&'static str]);

/// The targets.
const TARGETS: [Target; 4] = [
    ("design", LAW, &[]),
    ("laws", LAW, &[]),
    ("read", 16_384, &["exchange/tests/files", "exchange/tests/real"]),
    ("totality", LAW, &[]),
];

/// The largest input of a law: what chooses the law, and the words of a scene.
const LAW: u32 = 264;

/// Seconds for which `full` runs all targets at once.
const SECONDS: u32 = 30;

/// What the compiler adds for libFuzzer: a counter for each edge with its place, and the operands of comparisons.
const FLAGS: [&str; 5] = [
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
];

/// The options of `fuzz`.
#[derive(Debug, PartialEq, clap::Args)]
pub(crate) struct FuzzOptions {
    /// The target
    #[arg(value_name = "TARGET", value_parser = TARGETS.map(|(name, ..)| name))]
    target: String,
    /// For how long it searches
    #[arg(long, value_name = "N", default_value_t = 600)]
    seconds: u32,
}

/// Adds the step, which prints how many inputs each target has executed.
pub(crate) fn step(suite: &mut Suite) {
    suite.remarked(&format!("fuzz: all targets search for {SECONDS} s"), |progress| {
        install::program(&tool::CXX, progress)?;
        progress.run(build("build", &["--bins"]))?;
        let searches = TARGETS.iter().map(|target| search(target, SECONDS)).collect::<Result<_>>()?;
        TARGETS
            .iter()
            .zip(progress.outputs(searches)?)
            .map(|((name, ..), output)| told(name, &output))
            .collect()
    });
}

/// Runs one target.
pub(crate) fn run(options: &FuzzOptions) -> Result<()> {
    let progress = Progress::Live;
    let target = TARGETS.iter().find(|(name, ..)| *name == options.target).context("no such target")?;
    install::program(&tool::CXX, &progress)?;
    let output = progress.output(search(target, options.seconds)?)?;
    println!("{}", told(&options.target, &output)?);
    Ok(())
}

/// Returns a call of cargo that compiles with coverage.
fn build(word: &str, arguments: &[&str]) -> Command {
    let mut build = cargo([word, "--release", "--target", "host-tuple"]);
    build.args(arguments).current_dir(project::root().join("tests/fuzz"));
    // With a target, the flags do not reach build scripts, which would not link.
    build.env("CARGO_ENCODED_RUSTFLAGS", FLAGS.join("\x1f")).env("CARGO_TARGET_DIR", folder());
    build
}

/// The folder of what is built and found.
fn folder() -> PathBuf {
    project::target().join("fuzz")
}

/// Returns the search of a target. Inputs that reach more are kept for the next search, and one that crashes is too.
fn search((name, longest, seeds): &Target, seconds: u32) -> Result<Command> {
    let corpus = folder().join("corpus").join(name);
    fs::create_dir_all(&corpus).with_context(|| format!("cannot make {}", corpus.display()))?;
    let mut search = build("run", &["--bin", name, "--"]);
    search.arg(format!("-max_total_time={seconds}")).arg(format!("-max_len={longest}")).arg("-timeout=25");
    search.arg(format!("-artifact_prefix={}/{name}-", folder().display()));
    search.arg(corpus).args(seeds.iter().map(|seeds| project::root().join(seeds)));
    Ok(search)
}

/// Returns the counts of a search: its inputs, and the edges that they cover.
fn told(name: &str, output: &str) -> Result<String> {
    let last = output.lines().rev().find(|line| line.starts_with('#') && line.contains("DONE"));
    let words: Vec<_> = last.context("the fuzzer has not ended")?.split_whitespace().collect();
    let after = |word| words.iter().skip_while(|other| **other != word).nth(1).copied();
    let (runs, edges) = words[0].strip_prefix('#').zip(after("cov:")).context("no counts of the fuzzer")?;
    Ok(format!("{name}: {runs} inputs, {edges} edges"))
}
