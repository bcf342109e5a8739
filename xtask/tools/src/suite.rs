//! Runs named steps one after the other, reports each, and sums up.

use std::io::{self, Write};
use std::path::Path;
use std::process::{Command, ExitCode};
use std::thread;
use std::time::Instant;

use anyhow::{Context, Result};
use serde::Deserialize as _;
use serde_json::{Value, json};

use crate::progress::Progress;
use crate::tally::Tally;
use crate::{command, project};

/// The steps that have been run so far. After a step that fails, the next is still run.
#[derive(Debug)]
pub struct Suite {
    only: Option<String>,
    start: Instant,
    tally: Tally,
    failures: Vec<String>,
    /// The processor time of the programs that each step started, in seconds.
    times: Vec<(String, f64)>,
    /// Whether other steps run at the same time.
    has_company: bool,
}

/// Steps that run one after the other, beside other groups.
pub type Group<'a> = Box<dyn FnOnce(&mut Suite) + Send + 'a>;

/// Number of the most expensive steps that are listed.
const LISTED: usize = 15;

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

    /// Whether only some steps are to be run, so that others that they rely on may not have been.
    pub fn is_selective(&self) -> bool {
        self.only.is_some()
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
        let (start, before) = (Instant::now(), command::processor_seconds());
        let progress = Progress::kept();
        let outcome = work(&progress);
        let (seconds, processor) = (start.elapsed().as_secs_f64(), command::processor_seconds() - before);
        self.times.push((name.to_owned(), processor));
        let tally = outcome.as_ref().map_or(Tally::FAILED, |(_, tally)| *tally);
        let tests = if tally.passed + tally.failed == 1 { String::new() } else { format!(" ({tally})") };
        self.tally += tally;
        let name_again = if self.has_company { format!("{name:.<90} ") } else { String::new() };
        if tally.failed == 0 {
            println!("{name_again}pass {seconds:6.1} s, {processor:6.1} s CPU{tests}");
        } else {
            let reason = match &outcome {
                Ok(_) => format!("{} of its tests failed or were ignored", tally.failed),
                Err(error) => format!("{error:#}"),
            };
            let text = progress.into_text();
            println!(
                "{name_again}FAIL {seconds:6.1} s, {processor:6.1} s CPU{tests}\n{text}error: {reason}\n"
            );
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

    /// Runs steps in another program, whose suite [writes a report](Self::report) to the file that is
    /// the last argument. The program prints its steps itself.
    pub fn run_elsewhere(&mut self, mut program: Command) {
        let name = command::describe(&program);
        let mut run = || {
            let report = project::target().join("report.json");
            program.arg(&report).current_dir(project::root());
            command::run_to_its_end(&mut program)?;
            let text = std::fs::read_to_string(&report)?;
            std::fs::remove_file(&report)?;
            self.read(&serde_json::from_str(&text).context("it has not written its report")?)
        };
        if let Err(error) = run() {
            println!("{name:.<90} FAIL\nerror: {error:#}\n");
            self.tally += Tally::FAILED;
            self.failures.push(format!("{name}: {error:#}"));
        }
    }

    /// Whether the suite is one part of a larger one: its steps are printed when they have ended.
    #[must_use]
    pub fn beside_others(mut self) -> Self {
        self.has_company = true;
        self
    }

    /// Writes the counts, failures and times for the suite that [ran this
    /// program](Self::run_elsewhere).
    pub fn report(self, file: &Path) -> Result<()> {
        let report = json!({
            "passed": self.tally.passed, "failed": self.tally.failed,
            "failures": self.failures, "times": self.times,
        });
        std::fs::write(file, report.to_string()).with_context(|| format!("cannot write {}", file.display()))
    }

    fn read(&mut self, report: &Value) -> Result<()> {
        let count = |name: &str| report[name].as_u64().with_context(|| format!("no number `{name}`"));
        self.tally += Tally { passed: count("passed")?, failed: count("failed")? };
        self.failures.extend(Vec::<String>::deserialize(&report["failures"])?);
        self.times.extend(Vec::<(String, f64)>::deserialize(&report["times"])?);
        Ok(())
    }

    /// Prints the most expensive steps, the failures and, as the last line, the counts.
    pub fn finish(mut self) -> ExitCode {
        println!("\nthe most expensive steps, in seconds of processor time:");
        self.times.sort_by(|a, b| b.1.total_cmp(&a.1));
        for (name, processor) in self.times.iter().take(LISTED) {
            println!("{processor:7.1} s {name}");
        }
        println!();
        for failure in &self.failures {
            println!("FAIL {failure}");
        }
        if self.tally == Tally::default() {
            println!("no step matches the text of --only");
        }
        let processor: f64 = self.times.iter().map(|(_, processor)| processor).sum();
        println!("ran for {:.0} s, {processor:.0} s of processor time", self.start.elapsed().as_secs_f64());
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
    fn a_report_is_added_to_the_suite_that_reads_it() {
        let mut part = Suite::new(None).beside_others();
        part.step("one", |_| bail!("broken"));
        part.count("many", |_| Ok(Tally { passed: 5, failed: 0 }));
        let (file, times) = (tempfile::NamedTempFile::new().unwrap(), part.times.clone());
        part.report(file.path()).unwrap();
        let mut whole = Suite::new(None);
        let report = std::fs::read_to_string(file.path()).unwrap();
        whole.read(&serde_json::from_str(&report).unwrap()).unwrap();
        assert_eq!((whole.tally, whole.times), (Tally { passed: 5, failed: 1 }, times));
        assert_eq!(whole.failures, ["one: broken"]);
        assert!(Suite::new(None).read(&Value::Null).is_err());
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
