//! Prints the errors of the kernels, or their times on this machine.
//!
//! `cargo run --release --package luminaire-prices -- errors 15` prints the errors in a cone of an outer half
//! angle in degrees, `-- errors` in the standard cone, and `-- time` the times.
#![forbid(unsafe_code)]

use std::process::ExitCode;
use std::time::Instant;

use luminaire::HalfAngle;
use luminaire_kernels::Setting;
use luminaire_prices::{Clock, errors, time};

fn main() -> ExitCode {
    let words: Vec<_> = std::env::args().skip(1).collect();
    let degrees = words.get(1).and_then(|word| word.parse().ok());
    let setting = degrees.map(|degrees| Setting::ending_at(HalfAngle::degrees(degrees)));
    match (words.first().map(String::as_str), setting) {
        (Some("errors"), setting) => print!("{}", errors(setting.unwrap_or(Setting::standard()))),
        (Some("time"), None) => {
            let clock = Monotonic(Instant::now());
            let times = (0..).map(|number| time(number, &clock)).take_while(|lines| !lines.is_empty());
            times.for_each(|lines| print!("{lines}"));
        }
        _ => {
            eprintln!("error: expected `errors [DEGREES]` or `time`");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
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
