//! `cargo xtask mutants`: changes the kernel in small ways, and counts the changes that the tests
//! notice.

use std::process::ExitCode;

use anyhow::Result;
use clap::Parser;
use luminaire_mutants::{Options, run as test};

use tools::progress::Progress;
use tools::project;

/// Test the tests: change the kernel in small ways and list the changes that no test notices. By default,
/// the changes are on lines that changed since the last release.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask mutants")]
struct Request {
    /// Test the mutants of all lines, as is also done if the history has no tag v*
    #[arg(long, conflicts_with = "since")]
    all: bool,
    /// Test the mutants of lines that changed since this revision, instead of since the last tag v*
    #[arg(long, value_name = "REV")]
    since: Option<String>,
    /// Test the mutants of all lines of this file, changed or not
    #[arg(long, value_name = "PATH", conflicts_with_all = ["all", "since"])]
    file: Option<String>,
    /// Test only this many mutants, drawn at random
    #[arg(long, value_name = "N")]
    sample: Option<usize>,
    /// Seed of the draw
    #[arg(long, value_name = "S", default_value_t = 0)]
    seed: u64,
    /// Test this many mutants at the same time
    #[arg(long, value_name = "N", default_value_t = 2)]
    jobs: usize,
}

/// Prints the survivors and, as the last line, how many mutants were killed. Fails if there is a
/// survivor.
fn main() -> Result<ExitCode> {
    let Request { all, since, file, sample, seed, jobs } = Request::parse();
    let release = || if all || file.is_some() { None } else { project::last_release() };
    let since = since.or_else(release);
    let chosen = Options { since, file, sample, seed, jobs };
    let folder = project::target().join("mutants");
    let tell = |text: &str| Progress::Live.say("Mutants", text);
    let summary = test(project::root(), &folder, &chosen, &tell)?;
    summary.survivors.iter().for_each(|survivor| println!("{survivor}"));
    if summary.compiled > 0 {
        println!("not tested: {} mutants in functions that run at compile time only", summary.compiled);
    }
    println!("{summary}");
    Ok(if summary.survivors.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
