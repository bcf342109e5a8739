//! The project's commands, run by cargo itself: `cargo demo` and `cargo xtask test`.

mod arguments;
mod browsers;
mod contributing;
mod demo;
mod export;
mod msrv;
mod mutants;
mod package;
#[cfg(test)]
mod phrases;
mod pictures;
mod renderers;
mod scripts;
mod semver;
mod test;

use std::process::ExitCode;

use clap::Parser;
use measure::{boards, conform, device, effects, frame, pick, prices, rivals, size};

use arguments::Request;

fn main() -> ExitCode {
    let outcome = match Request::parse() {
        Request::Conform(options) => conform::run(&options),
        Request::Demo(options) => demo::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Effects(options) => effects::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Pictures => pictures::run().map(|()| ExitCode::SUCCESS),
        Request::Renderers => renderers::run().map(|()| ExitCode::SUCCESS),
        Request::Board(options) => device::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Firmware(options) => boards::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Frame(options) => frame::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Pick(options) => pick::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Rivals(options) => rivals::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Size(options) => size::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Measure(options) => prices::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Mutants(options) => mutants::run(options),
        Request::Test(options) => Ok(test::run(options, false)),
        Request::Full(options) => Ok(test::run(options, true)),
    };
    outcome.unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        ExitCode::FAILURE
    })
}
