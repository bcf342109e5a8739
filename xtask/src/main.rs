//! The project's commands, run by cargo itself: `cargo demo` and `cargo xtask test`.
//!
//! What measures, and what needs an emulated board or drives a browser, is the laboratory's, a program
//! that is built when one of its commands is first called.

mod arguments;
mod contributing;
mod demo;
#[cfg(test)]
mod documents;
mod features;
mod lab;
mod msrv;
mod scripts;
mod semver;
mod test;

use std::env;
use std::process::ExitCode;

use anyhow::Result;

use arguments::Request;

fn main() -> ExitCode {
    run().unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        ExitCode::FAILURE
    })
}

fn run() -> Result<ExitCode> {
    match arguments::parse(env::args_os().skip(1).collect())? {
        Request::Help => print!("{}", arguments::HELP),
        Request::Demo(options) => demo::run(&options)?,
        Request::Test { is_full, only } => return Ok(test::run(only, is_full)),
        Request::Laboratory(words) => return lab::run(&words),
    }
    Ok(ExitCode::SUCCESS)
}
