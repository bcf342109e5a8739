//! `cargo xtask conform`: the conformance vectors, checked on every target or rewritten.

use std::env::consts::EXE_SUFFIX;
use std::fs::{self, File};
use std::path::PathBuf;
use std::process::{Command, ExitCode};

use anyhow::{Context, Result, bail, ensure};
use tools::browser::Visit;

use crate::counted;
use crate::qemu::Qemu;
use crate::target::{BOARDS, Board, Target};
use tools::progress::Progress;
use tools::server::Server;
use tools::suite::Suite;
use tools::{command, project, wasm};

/// The options of `conform`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub struct ConformOptions {
    /// Check this one only: host, wasm-simd or a processor; may be repeated
    #[arg(long = "target", value_name = "NAME", value_parser = Target::named)]
    pub targets: Vec<Target>,
    /// Write the vectors again as the host computes them
    #[arg(long)]
    pub bless: bool,
}

/// The targets. In a browser the flags are those of the demo, so that the check holds for its pixels.
fn all() -> Vec<Target> {
    [Target::Host, Target::Browser { simd: true }]
        .into_iter()
        .chain(BOARDS.iter().map(Target::Board))
        .collect()
}

/// Adds a step for each target. Without `full`, these are a browser and the smallest board.
pub fn steps(suite: &mut Suite, full: bool) {
    for target in if full { all() } else { vec![all()[1], all()[2]] } {
        suite.remarked(&format!("conformance: the same bits on {}", target.name()), |progress| {
            check(target, progress)
        });
    }
}

/// Checks the targets and prints a line for each, or with `bless` writes the vectors. If one target cannot
/// be run, the next is still run.
pub fn run(options: &ConformOptions) -> Result<ExitCode> {
    let progress = Progress::Live;
    if options.bless {
        let vectors = command::answer(Command::new(host(&[], "debug", &progress)?).arg("generate"))? + "\n";
        ensure!(cases(&vectors) > 0, "no case was generated");
        fs::write(file(), vectors)?;
        return Ok(ExitCode::SUCCESS);
    }
    let mut code = ExitCode::SUCCESS;
    for target in if options.targets.is_empty() { all() } else { options.targets.clone() } {
        match check(target, &progress) {
            Ok(counts) => println!("{}: {}", target.name(), counts.join(", ")),
            Err(error) => {
                println!("{}: {error:#}", target.name());
                code = ExitCode::FAILURE;
            }
        }
    }
    Ok(code)
}

fn folder() -> PathBuf {
    project::root().join("tests/conform")
}

fn file() -> PathBuf {
    folder().join("vectors.txt")
}

/// The number of cases of the vectors.
fn cases(vectors: &str) -> usize {
    let rows = vectors.lines().map(|line| line.split('#').next().unwrap_or_default());
    rows.filter(|row| row.contains(" -> ")).count()
}

/// Checks the vectors on a target. Returns the counts; an error if a case differs or was not checked.
fn check(target: Target, progress: &Progress) -> Result<Vec<String>> {
    let outputs = match target {
        Target::Errors | Target::Browser { simd: false } | Target::OfC(_) => {
            bail!("target = {}: expected host, wasm-simd or a processor with kernels in Rust", target.name())
        }
        // Optimised and without overflow checks: an overflow would wrap unnoticed. The tests of
        // `cargo test` check the vectors with overflow checks.
        Target::Host => vec![
            on_the_host(&["--release"], progress)?,
            on_the_host(&["--release", "--features", "std"], progress)?,
        ],
        Target::Browser { simd: true } => vec![in_a_browser(progress)?],
        Target::Board(board) => vec![on_a_board(board, progress)?],
    };
    let cases = cases(&fs::read_to_string(file())?);
    outputs.iter().try_for_each(|output| is_passed(output, cases))?;
    Ok(vec![format!("{cases} cases, 0 differ")])
}

/// Fails if the output of a check has another last line than that of passed cases.
fn is_passed(output: &str, cases: usize) -> Result<()> {
    let last = output.trim_end().lines().next_back().unwrap_or_default();
    ensure!(last == format!("{cases} cases, 0 differ"), "expected {cases} cases, 0 differ, found\n{output}");
    Ok(())
}

/// Builds the program `conform` for this machine.
fn host(options: &[&str], profile: &str, progress: &Progress) -> Result<PathBuf> {
    let mut build = command::cargo(["build", "--package", "luminaire-conform", "--bin", "conform"]);
    build.args(options);
    progress.run(build)?;
    Ok(project::target().join(profile).join(format!("conform{EXE_SUFFIX}")))
}

fn on_the_host(options: &[&str], progress: &Progress) -> Result<String> {
    let mut check = Command::new(host(options, "release", progress)?);
    let output = check.arg("check").stdin(File::open(file())?).output().context("cannot run the check")?;
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

fn on_a_board(board: &'static Board, progress: &Progress) -> Result<String> {
    // A flash of 256 kB holds all models at once only if the models are compiled for size.
    let is_small = ["cortex-m0", "cortex-m3"].contains(&board.name);
    let profile = if is_small { "size" } else { "release" };
    let options = ["--profile", profile, "--bin", "conform", "--features", "conform"];
    let program = counted::build(board, &options, progress)?.artifacts(profile).join("conform");
    // The program reads the vectors from the folder that QEMU is started in.
    let mut qemu = Qemu::find(board, progress)?.command();
    command::answer(qemu.current_dir(folder()).arg("-kernel").arg(program))
}

/// Builds the page, opens it, and returns what it reports.
fn in_a_browser(progress: &Progress) -> Result<String> {
    let site = project::target().join("conform");
    wasm::CONFORM.bind(&wasm::CONFORM.compile(wasm::LOCAL, progress)?, &site.join("pkg"), progress)?;
    fs::copy(folder().join("wasm/index.html"), site.join("index.html"))?;
    fs::copy(file(), site.join("vectors.txt"))?;
    let server = Server::start(&site)?;
    let visit = Visit { address: &server.address(), ..Visit::default() };
    let report = visit.ask("document.getElementById('report').textContent", progress)?;
    Ok(report.as_str().context("the page has no report")?.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn report_must_count_every_case() {
        assert_eq!(cases("# a -> comment\n[spot fx16] point\n0001 -> 4000 # axis\n0002 -> 0000\n"), 2);
        assert!(is_passed("12 cases, 0 differ\n", 12).is_ok());
        for output in ["11 cases, 0 differ", "line 9: 00 -> 01\n12 cases, 1 differ\n", "panicked"] {
            assert!(is_passed(output, 12).unwrap_err().to_string().contains(output), "{output}");
        }
    }
}
