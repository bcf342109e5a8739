//! The command line.

use measure::MeasureOptions;
use measure::conform::ConformOptions;
use measure::device::DeviceOptions;

use crate::fuzz::FuzzOptions;
use crate::test::{FullOptions, TestOptions};

/// The commands of the laboratory.
#[derive(Debug, PartialEq, clap::Parser)]
#[command(name = "cargo xtask", disable_help_subcommand = true, arg_required_else_help = true)]
pub(crate) enum Request {
    /// Run the tests: format, lints, documentation, host, an emulated board, a browser
    Test(TestOptions),
    /// Run the tests with the long sweeps, on all boards, in all browsers, with all feature sets, and
    /// from the packed crates; continue a run that was interrupted
    Full(FullOptions),
    /// Prove the errors of the fixed-point stages, by Gappa and Coq, and that C is defined, by Frama-C
    Prove,
    /// Search inputs that break a law of the kernel or a reader of files, by libFuzzer
    Fuzz(FuzzOptions),
    /// Take the pictures of the demo for the documents again
    Pictures,
    /// Draw the pictures of renderers that are not the project's
    Renderers,
    /// Build the firmware of a board with a display, or of a console: rp2040, gba
    Board(DeviceOptions),
    /// Time frames of the demo and of three.js without a GPU, in one run
    Rivals,
    /// Measure errors, and costs on every target, and compare them with the record or write it
    Measure(MeasureOptions),
    /// Compare the results of every model, bit by bit, with the conformance vectors on every target
    Conform(ConformOptions),
}

#[cfg(test)]
mod tests {
    use clap::{CommandFactory as _, Parser as _};

    use super::*;

    fn parse(line: &str) -> Result<Request, clap::Error> {
        Request::try_parse_from(["lab"].into_iter().chain(line.split_whitespace()))
    }

    #[test]
    fn a_refused_word_is_named_with_what_is_expected() {
        for (line, name) in [
            ("tset", "tset"),
            ("measure --check --bless", "--bless"),
            ("measure --target gpu", "wasm-simd"),
            ("fuzz law", "totality"),
            ("conform --target cortex-m1", "cortex-m1"),
        ] {
            let error = parse(line).unwrap_err().to_string();
            assert!(error.contains(name), "`{line}` was refused with: {error}");
        }
    }

    /// `cargo xtask --help` lists the commands of the laboratory without building it.
    #[test]
    fn commands_are_those_that_the_help_lists() {
        let list = include_str!("../../../xtask/src/arguments.rs");
        for command in Request::command().get_subcommands() {
            let name = command.get_name();
            assert!(list.contains(&format!("\n  {name} ")), "{name} is not in the list of xtask");
        }
    }
}
