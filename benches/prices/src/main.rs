//! Prints the errors of the kernels, or their times on this machine.
//!
//! `cargo run --release --package luminaire-prices -- accuracy`, `-- ladder` or `-- time`.
#![forbid(unsafe_code)]

use std::process::ExitCode;
use std::time::Instant;

use luminaire::HalfAngle;
use luminaire::falloff::{Hard, Soft};
use luminaire_kernels::Setting;
use luminaire_prices::{Accuracy, Clock, Rung, Times};
use serde::Serialize;

/// Outer half angles in degrees at which errors are measured in addition to the standard cone,
/// because there the cosine form and the versine form differ.
const NARROWER: [f32; 3] = [15.0, 5.0, 1.0];

/// Outer half angles in degrees at which the evaluations are compared.
const RUNGS: [f32; 7] = [1.0, 3.0, 5.0, 15.0, 22.0, 45.0, 80.0];

fn main() -> ExitCode {
    let words: Vec<_> = std::env::args().skip(1).collect();
    match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["accuracy"] => accuracy(),
        ["ladder"] => ladder(),
        ["time"] => time(),
        _ => {
            eprintln!("error: ask for `accuracy`, `ladder` or `time`");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}

fn accuracy() {
    let narrower = NARROWER.map(|degrees| Setting::ending_at(HalfAngle::degrees(degrees)));
    for setting in [Setting::standard()].into_iter().chain(narrower) {
        for row in Accuracy::of_all(setting) {
            print(&row);
        }
    }
}

fn ladder() {
    for setting in RUNGS.map(|degrees| Setting::ending_at(HalfAngle::degrees(degrees))) {
        Rung::of_all::<Soft>(setting).iter().chain(&Rung::of_all::<Hard>(setting)).for_each(print);
    }
}

fn time() {
    let clock = Monotonic(Instant::now());
    for row in (0..Times::count()).filter_map(|number| Times::of(number, &clock)) {
        print(&row);
    }
}

fn print(row: &impl Serialize) {
    println!("{}", serde_json::to_string(row).expect("figures are JSON"));
}

/// The operating system's clock.
struct Monotonic(Instant);

impl Clock for Monotonic {
    fn now(&self) -> f64 {
        self.0.elapsed().as_secs_f64() * 1e9
    }

    /// Long compared with the cost of reading the clock, and short compared with a time slice, so
    /// that most samples are undisturbed on a shared machine.
    fn shortest(&self) -> f64 {
        200_000.0
    }
}
