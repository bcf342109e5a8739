//! The project's commands, run by cargo itself: `cargo demo` and `cargo xtask test`.

mod arguments;
mod browser;
mod command;
mod conform;
mod contributing;
mod demo;
mod effects;
mod firmware;
mod http;
mod install;
mod measure;
mod msrv;
mod package;
#[cfg(test)]
mod phrases;
mod pictures;
mod progress;
mod project;
mod server;
mod shrink;
mod site;
mod size;
mod suite;
mod tally;
mod test;
mod toolchain;
mod turntable;
mod wasm;

use std::process::ExitCode;

use clap::Parser;

use arguments::Request;

fn main() -> ExitCode {
    let outcome = match Request::parse() {
        Request::Conform(options) => conform::run(&options),
        Request::Demo(options) => demo::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Effects(options) => effects::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Pictures => pictures::run().map(|()| ExitCode::SUCCESS),
        Request::Firmware(options) => firmware::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Frame(options) => firmware::frame::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Size(options) => size::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Measure(options) => measure::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Test(options) => Ok(test::run(options, false)),
        Request::Full(options) => Ok(test::run(options, true)),
    };
    outcome.unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        ExitCode::FAILURE
    })
}
