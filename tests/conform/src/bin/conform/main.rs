//! Writes the conformance vectors, or checks this machine against them.
//!
//! `conform generate` prints the file. `conform check` reads the file from stdin and prints the
//! first cases that differ. Its last line states the number of cases and how many of them differ.

mod scene;
mod situation;
mod writer;

use std::process::ExitCode;
use std::{env, io};

use luminaire_conform::Check;

fn main() -> ExitCode {
    match env::args().nth(1).as_deref() {
        Some("generate") => {
            print!("{}", writer::file());
            ExitCode::SUCCESS
        }
        Some("check") => check(),
        _ => {
            eprintln!("usage: conform generate | conform check");
            ExitCode::from(2)
        }
    }
}

fn check() -> ExitCode {
    let (mut check, mut report) = (Check::default(), String::new());
    for line in io::stdin().lines().map_while(Result::ok) {
        // Writing to a string does not fail.
        let _ = check.take(&line, &mut report);
    }
    println!("{report}{check}");
    if check.is_passed() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
