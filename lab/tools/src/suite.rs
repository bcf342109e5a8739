//! Runs named steps one after the other, reports each, and sums up.

use std::io::{self, Write};
use std::process::ExitCode;
use std::thread;
use std::time::Instant;

use anyhow::Result;

use crate::progress::Progress;
use crate::tally::Tally;

/// The steps that have been run so far. After a step that fails, the next is still run.
#[derive(Debug)]
pub struct Suite {
    only: Option<String>,
    start: Instant,
    tally: Tally,
    failures: Vec<String>,
    /// The seconds that each step took.
    times: Vec<(String, f64)>,
    /// Whether other steps run at the same time.
    has_company: bool,
}

/// Steps that run one after the other, beside other groups.
pub type Group<'a> = Box<dyn FnOnce(&mut Suite) + Send + 'a>;

/// Number of the slowest steps that are listed.
const SLOWEST: usize = 10;

/// The processor time, in seconds, of all child processes that have ended, if the system states it
/// in `/proc`.
fn processor_seconds() -> Option<f64> {
    /// Ticks of Linux's time counters per second, the same on every processor.
    const TICKS_A_SECOND: f64 = 100.0;
    let status = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The program's name is in parentheses and may contain spaces, so the fields are counted from
    // the last parenthesis.
    let mut fields = status.rsplit_once(')')?.1.split_whitespace().skip(13);
    let [user, system] = [fields.next()?, fields.next()?].map(|ticks| ticks.parse::<f64>().ok());
    Some((user? + system?) / TICKS_A_SECOND)
}

impl Suite {
    /// A suite of all steps, or of the steps whose name contains `only`.
    pub fn new(only: Option<String>) -> Self {
        Self {
            only,
            start: Instant::now(),
            tally: Tally::default(),
            failures: Vec::new(),
            times: Vec::new(),
            has_company: false,
        }
    }

    /// Whether a step with this name is to be run.
    pub fn wants(&self, name: &str) -> bool {
        self.only.as_ref().is_none_or(|only| name.contains(only))
    }

    /// Runs a step that counts as one test, if it is wanted.
    pub fn step(&mut self, name: &str, work: impl FnOnce(&Progress) -> Result<()>) {
        self.count(name, |progress| work(progress).map(|()| Tally::PASSED));
    }

    /// Runs a step that counts its own tests, if it is wanted.
    pub fn count(&mut self, name: &str, work: impl FnOnce(&Progress) -> Result<Tally>) {
        if self.wants(name) {
            self.run(name, |progress| work(progress).map(|tally| ((), tally)));
        }
    }

    /// Runs a step that counts as one test, if it is wanted, and prints its remarks below it.
    pub fn remarked(&mut self, name: &str, work: impl FnOnce(&Progress) -> Result<Vec<String>>) {
        if self.wants(name) {
            for remark in self.require(name, work).unwrap_or_default() {
                println!("    {remark}");
            }
        }
    }

    /// Runs a step that other steps need, whether it is wanted or not.
    pub fn require<T>(&mut self, name: &str, work: impl FnOnce(&Progress) -> Result<T>) -> Option<T> {
        self.run(name, |progress| work(progress).map(|value| (value, Tally::PASSED)))
    }

    fn run<T>(&mut self, name: &str, work: impl FnOnce(&Progress) -> Result<(T, Tally)>) -> Option<T> {
        if !self.has_company {
            print!("{name:.<90} ");
            // An error does not matter: the name would only appear later.
            let _ = io::stdout().flush();
        }
        let start = Instant::now();
        let progress = Progress::kept();
        let outcome = work(&progress);
        let seconds = start.elapsed().as_secs_f64();
        self.times.push((name.to_owned(), seconds));
        let tally = outcome.as_ref().map_or(Tally::FAILED, |(_, tally)| *tally);
        let tests = if tally.passed + tally.failed == 1 { String::new() } else { format!(" ({tally})") };
        self.tally += tally;
        let name_again = if self.has_company { format!("{name:.<90} ") } else { String::new() };
        if tally.failed == 0 {
            println!("{name_again}pass {seconds:6.1} s{tests}");
        } else {
            let reason = match &outcome {
                Ok(_) => format!("{} of its tests failed or were ignored", tally.failed),
                Err(error) => format!("{error:#}"),
            };
            let text = progress.into_text();
            println!("{name_again}FAIL {seconds:6.1} s{tests}\n{text}error: {reason}\n");
            self.failures.push(format!("{name}: {reason}"));
        }
        outcome.ok().map(|(value, _)| value)
    }

    /// Runs groups of steps in parallel, for steps that keep only one processor busy. Each step is
    /// reported when it has ended.
    pub fn side_by_side<const N: usize>(&mut self, groups: [Group<'_>; N]) {
        let only = &self.only;
        let run = |group: Group<'_>| {
            let mut suite = Self { has_company: true, ..Self::new(only.clone()) };
            group(&mut suite);
            suite
        };
        let ended = thread::scope(|scope| {
            let threads = groups.map(|group| scope.spawn(|| run(group)));
            threads.map(|thread| thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
        });
        for mut suite in ended {
            self.tally += suite.tally;
            self.failures.append(&mut suite.failures);
            self.times.append(&mut suite.times);
        }
    }

    /// Prints the slowest steps, the failures and, as the last line, the counts.
    pub fn finish(mut self) -> ExitCode {
        println!("\nthe slowest steps:");
        self.times.sort_by(|a, b| b.1.total_cmp(&a.1));
        for (name, seconds) in self.times.iter().take(SLOWEST) {
            println!("{seconds:7.1} s {name}");
        }
        println!();
        for failure in &self.failures {
            println!("FAIL {failure}");
        }
        if self.tally == Tally::default() {
            println!("no step matches the text of --only");
        }
        let processor = processor_seconds().map(|seconds| format!(", {seconds:.0} s of processor time"));
        println!("ran for {:.0} s{}", self.start.elapsed().as_secs_f64(), processor.unwrap_or_default());
        println!("{}", self.tally);
        let well = self.tally.failed == 0 && self.tally.passed > 0;
        if well { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}

#[cfg(test)]
mod tests {
    use anyhow::bail;

    use super::*;

    #[test]
    fn a_failure_is_counted_and_the_next_step_still_runs() {
        let mut suite = Suite::new(None);
        suite.step("one", |_| bail!("broken"));
        suite.step("two", |_| Ok(()));
        suite.count("many", |_| Ok(Tally { passed: 5, failed: 1 }));
        assert_eq!(suite.tally, Tally { passed: 6, failed: 2 });
        assert_eq!(suite.failures, ["one: broken", "many: 1 of its tests failed or were ignored"]);
    }

    #[test]
    fn steps_side_by_side_are_counted_together() {
        let mut suite = Suite::new(None);
        suite.side_by_side([
            Box::new(|suite| suite.step("one", |_| Ok(()))),
            Box::new(|suite| suite.step("two", |_| bail!("broken"))),
        ]);
        assert_eq!(suite.tally, Tally { passed: 1, failed: 1 });
        assert_eq!((suite.failures, suite.times.len()), (vec!["two: broken".to_owned()], 2));
    }

    #[test]
    fn only_wanted_and_required_steps_run() {
        let mut suite = Suite::new(Some("camera".into()));
        suite.step("browser: the camera moves", |_| Ok(()));
        suite.step("format", |_| bail!("never run"));
        assert_eq!(suite.require("the demo is built", |_| Ok(7)), Some(7));
        assert_eq!(suite.tally, Tally { passed: 2, failed: 0 });
    }
}
