//! `cargo xtask conform`: the conformance vectors, checked on every target or rewritten.

mod page;
pub mod steps;
mod target;
mod vectors;

use std::process::ExitCode;

use anyhow::Result;

use tools::progress::Progress;

pub(crate) use target::Target;

use self::vectors::Vectors;
use crate::record;

/// The options of `conform`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub struct ConformOptions {
    /// Check this one only: host, wasm, cortex-m0, cortex-m3, cortex-m4f or rv32imc; may be
    /// repeated
    #[arg(long = "target", value_name = "NAME", value_parser = Targets::named)]
    pub targets: Vec<Targets>,
    /// Write the vectors again as the host computes them, and print what changed
    #[arg(long)]
    pub bless: bool,
}

/// What a name on the command line stands for.
#[derive(Clone, Debug, PartialEq)]
pub struct Targets(Vec<Target>);

impl Targets {
    fn named(name: &str) -> Result<Self, String> {
        Target::named(name).map(Self)
    }
}

/// Checks the targets and prints a line for each, or with `bless` writes the vectors.
pub fn run(options: &ConformOptions) -> Result<ExitCode> {
    let progress = Progress::Live;
    if options.bless {
        record::write(&Vectors::generate(&progress)?, true, &progress)?;
        return Ok(ExitCode::SUCCESS);
    }
    let targets = if options.targets.is_empty() {
        Target::all()
    } else {
        options.targets.iter().flat_map(|targets| targets.0.clone()).collect()
    };
    let mut conforms = true;
    for target in targets {
        // If one target cannot be run, the next is still run.
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
