//! `cargo demo`, run by cargo itself, and a call of the laboratory.
//!
//! All other commands are the laboratory's, a program that is built when one of them is first called.

mod arguments;
mod demo;

use std::env;
use std::ffi::OsString;
use std::process::ExitCode;

use anyhow::{Context, Result};
use tools::{command, family, trouble};

use arguments::Request;

fn main() -> ExitCode {
    run().unwrap_or_else(|error| {
        eprintln!("error: {}", trouble::explained(&error));
        ExitCode::FAILURE
    })
}

fn run() -> Result<ExitCode> {
    family::end_together()?;
    match arguments::parse(env::args_os().skip(1).collect())? {
        Request::Help => print!("{}", arguments::HELP),
        Request::Demo(options) => demo::run(&options)?,
        Request::Laboratory(words) => return laboratory(&words),
    }
    Ok(ExitCode::SUCCESS)
}

/// Runs a command of the laboratory's program, which cargo builds if need be.
fn laboratory(words: &[OsString]) -> Result<ExitCode> {
    let mut cargo = command::cargo(["run", "--package", "lab", "--"]);
    let status = family::start(cargo.args(words)).and_then(|mut cargo| cargo.child.wait());
    let status = status.context("cannot start cargo")?;
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
