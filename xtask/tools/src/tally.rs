//! Counting what passed and what failed.

use std::fmt;
use std::iter::Sum;
use std::process::Command;

use anyhow::{Result, bail, ensure};

use crate::progress::Progress;

/// Numbers of passed and failed tests. A test that did not run counts in neither.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// Tests that passed.
    pub passed: u64,
    /// Tests that failed or were ignored.
    pub failed: u64,
}

impl Tally {
    /// One test that passed.
    pub const PASSED: Self = Self { passed: 1, failed: 0 };
    /// One test that failed.
    pub const FAILED: Self = Self { passed: 0, failed: 1 };

    /// Adds up the `test result:` lines of `cargo test`. An ignored test counts as failed, because
    /// it was not run.
    pub fn of_cargo_test(output: &str) -> Self {
        let results = output.lines().filter_map(|line| line.trim_start().strip_prefix("test result: "));
        let tally = |line: &str| {
            // As in `ok. 12 passed; 0 failed; …`.
            let words: Vec<_> = line.split([' ', ';']).collect();
            let count = |word| words.windows(2).find(|pair| pair[1] == word)?[0].parse::<u64>().ok();
            let [passed, failed, ignored] =
                ["passed", "failed", "ignored"].map(|word| count(word).unwrap_or_default());
            Self { passed, failed: failed + ignored }
        };
        results.map(tally).sum()
    }
}

/// Runs `cargo test` and adds up its results. It is an error if no test was run.
pub fn cargo_test(test: Command, progress: &Progress) -> Result<Tally> {
    let ended = progress.capture(test)?;
    let mut tally = Tally::of_cargo_test(&ended.output);
    ensure!(tally != Tally::default(), "no test was run");
    // A test program that does not compile, or that crashes, prints no `test result:` line.
    if !ended.success && tally.failed == 0 {
        tally = Tally { failed: 1, ..tally };
    }
    Ok(tally)
}

/// Runs tests by node and adds up its results. It is an error if no test was run.
pub fn node_test(test: Command, progress: &Progress) -> Result<Tally> {
    let output = progress.capture(test)?.output;
    let count = |word: &str| {
        let lines = output.lines().filter_map(|line| line.split_once(&format!(" {word} ")));
        lines.filter_map(|(_, number)| number.trim().parse::<u64>().ok()).next_back()
    };
    match (count("pass"), count("fail")) {
        (Some(passed), Some(failed)) if passed + failed > 0 => Ok(Tally { passed, failed }),
        _ => bail!("no test was run"),
    }
}

impl Sum for Tally {
    fn sum<I: Iterator<Item = Self>>(tallies: I) -> Self {
        tallies.fold(Self::default(), |sum, tally| Self {
            passed: sum.passed + tally.passed,
            failed: sum.failed + tally.failed,
        })
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{} passed, {} failed", self.passed, self.failed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_of_all_test_programs_are_added_and_an_ignored_test_has_not_passed() {
        let output = "
running 3 tests
7 passed; 1 failed
test result of mine ... ok
test result: ok. 3 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.00s
error: test failed, to rerun pass `-p luminaire --lib`
test result: FAILED. 10 passed; 2 failed; 1 ignored; 0 measured; 4 filtered out; finished in 1.20s
   Doc-tests luminaire
test result: ok. 7 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.31s

all doctests ran in 0.52s; merged doctests compilation took 0.20s
";
        assert_eq!(Tally::of_cargo_test(output).to_string(), "20 passed, 3 failed");
        assert_eq!(Tally::of_cargo_test("none"), Tally::default());
    }
}
