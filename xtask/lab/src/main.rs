//! The laboratory's commands, and the test run. `cargo xtask` calls this program.

mod arguments;
mod browsers;
mod contributing;
mod eva;
mod expected;
mod features;
mod fresh;
mod fuzz;
mod messages;
mod msrv;
mod package;
mod pictures;
mod portable;
mod prove;
mod readers;
mod renderers;
mod scripts;
mod semver;
mod test;

use std::process::ExitCode;

use clap::Parser;
use measure::{conform, device, rivals};
use tools::family;
use tools::suite::Suite;
use tools::trouble;

use arguments::Request;

fn main() -> ExitCode {
    if let Err(error) = family::end_together() {
        eprintln!("error: {error:#}");
        return ExitCode::FAILURE;
    }
    let done = |()| ExitCode::SUCCESS;
    let outcome = match Request::parse() {
        Request::Test(options) => Ok(test::run(options)),
        Request::Full(options) => test::run_full(options),
        Request::Prove => {
            let mut suite = Suite::new(None);
            suite.side_by_side([Box::new(prove::step), Box::new(eva::step)]);
            Ok(suite.finish())
        }
        Request::Fuzz(options) => fuzz::run(&options).map(done),
        Request::Pictures => pictures::run().map(done),
        Request::Renderers => renderers::run().map(done),
        Request::Board(options) => device::run(&options).map(done),
        Request::Rivals => rivals::run().map(done),
        Request::Measure(options) => measure::run(&options).map(done),
        Request::Conform(options) => conform::run(&options),
    };
    outcome.unwrap_or_else(|error| {
        eprintln!("error: {}", trouble::explained(&error));
        ExitCode::FAILURE
    })
}
