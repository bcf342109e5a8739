//! `cargo xtask conform`: the conformance vectors, checked on every target or written anew.

mod golden;
mod page;
mod target;
pub(crate) mod tests;

use std::process::ExitCode;

use anyhow::Result;

use crate::progress::Progress;

pub(crate) use target::Target;

/// The options of `conform`.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct ConformOptions {
    /// The targets to check; none means all.
    pub(crate) targets: Vec<Target>,
    /// Write the file anew instead of checking it.
    pub(crate) bless: bool,
}

/// Checks the targets and prints a line for each, or blesses.
pub(crate) fn run(options: &ConformOptions) -> Result<ExitCode> {
    let progress = Progress::Live;
    if options.bless {
        print!("{}", golden::bless(&progress)?);
        return Ok(ExitCode::SUCCESS);
    }
    let targets = if options.targets.is_empty() { Target::all() } else { options.targets.clone() };
    let mut conforms = true;
    for target in targets {
        // A target that cannot be run does not keep the next from running.
        match target.check(&progress) {
            Ok(report) => {
                print!("{}", report.told);
                println!("{}: {}", target.name(), report.count);
                conforms &= report.passed;
            }
            Err(error) => {
                println!("{}: not checked: {error:#}", target.name());
                conforms = false;
            }
        }
    }
    Ok(if conforms { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
