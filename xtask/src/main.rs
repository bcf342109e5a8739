//! The project's commands, run by cargo itself: `cargo demo` and `cargo xtask test`.
//!
//! What measures, and what needs an emulated board or drives a browser, is the laboratory's, a program
//! that is built when one of its commands is first called.

mod arguments;
mod contributing;
mod demo;
mod lab;
mod msrv;
#[cfg(test)]
mod phrases;
#[cfg(test)]
mod readme;
mod scripts;
mod semver;
mod test;

use std::process::ExitCode;

use clap::Parser;

use arguments::Request;

fn main() -> ExitCode {
    let outcome = match Request::parse() {
        Request::Demo(options) => demo::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Test(options) => Ok(test::run(options, false)),
        Request::Full(options) => Ok(test::run(options, true)),
        Request::Lab(words) => lab::run(&words),
    };
    outcome.unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        ExitCode::FAILURE
    })
}
