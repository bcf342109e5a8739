//! Runs named steps one after the other, reports each, and sums up.

use std::io::{self, Write};
use std::process::ExitCode;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Instant;

use anyhow::Result;

use crate::command;
use crate::progress::Progress;
use crate::record::Record;
use crate::tally::Tally;
use crate::trouble;

/// The steps that have been run so far. After a step that fails, the next is still run.
#[derive(Debug)]
pub struct Suite {
    only: Option<String>,
    start: Instant,
    done: Vec<Done>,
    /// Whether other steps run at the same time.
    has_company: bool,
    is_selective: bool,
    /// What has passed before on the same tree, if that is kept.
    record: Option<Kept>,
    /// The steps that were not wanted, and have not passed before.
    left: Vec<String>,
}

/// A record that groups of steps share.
type Kept = Arc<Mutex<Record>>;

/// A step that has ended.
#[derive(Debug)]
struct Done {
    tally: Tally,
    /// The processor time of the programs that it started, in seconds.
    processor: f64,
    /// Its name, and why it failed.
    failure: Option<String>,
}

/// Steps that run one after the other, beside other groups.
pub type Group<'a> = Box<dyn FnOnce(&mut Suite) + Send + 'a>;

impl Suite {
    /// A suite of all steps, or of the steps whose name contains `only`.
    pub fn new(only: Option<String>) -> Self {
        let (is_selective, start) = (only.is_some(), Instant::now());
        Self {
            only,
            start,
            done: Vec::new(),
            has_company: false,
            is_selective,
            record: None,
            left: Vec::new(),
        }
    }

    /// A suite whose passed steps are kept in a record: of all steps, those that have passed before are not
    /// run again.
    #[must_use]
    pub fn with_record(mut self, record: Record) -> Self {
        self.is_selective |= !record.is_empty();
        self.record = Some(Arc::new(Mutex::new(record)));
        self
    }

    /// Whether a step with this name is to be run: it has the text that is wanted, or else has not passed
    /// before.
    pub fn wants(&self, name: &str) -> bool {
        self.only.as_ref().map_or_else(|| self.passed(name).is_none(), |only| name.contains(only))
    }

    /// The tests of a step that has passed before.
    fn passed(&self, name: &str) -> Option<Tally> {
        let record = self.record.as_ref()?.lock().unwrap_or_else(PoisonError::into_inner);
        record.of(name)
    }

    /// Leaves out a step that is not wanted. If it has passed before, its tests count.
    pub fn skip(&mut self, name: &str) {
        match self.passed(name) {
            Some(tally) if self.only.is_none() => {
                println!("{name:.<90} passed before");
                self.done.push(Done { tally, processor: 0.0, failure: None });
            }
            Some(_) => {}
            None => self.left.push(name.to_owned()),
        }
    }

    /// Whether only some steps are to be run, so that others that they rely on may not have been.
    pub fn is_selective(&self) -> bool {
        self.is_selective
    }

    /// Runs a step that counts as one test, if it is wanted.
    pub fn step(&mut self, name: &str, work: impl FnOnce(&Progress) -> Result<()>) {
        self.count(name, |progress| work(progress).map(|()| Tally::PASSED));
    }

    /// Runs a step that counts its own tests, if it is wanted.
    pub fn count(&mut self, name: &str, work: impl FnOnce(&Progress) -> Result<Tally>) {
        if self.wants(name) {
            self.run(name, |progress| work(progress).map(|tally| ((), tally)));
        } else {
            self.skip(name);
        }
    }

    /// Runs a step that counts as one test, if it is wanted, and prints its remarks below it.
    pub fn remarked(&mut self, name: &str, work: impl FnOnce(&Progress) -> Result<Vec<String>>) {
        if self.wants(name) {
            for remark in self.require(name, work).unwrap_or_default() {
                println!("    {remark}");
            }
        } else {
            self.skip(name);
        }
    }

    /// Runs a step that other steps need, whether it is wanted or not.
    pub fn require<T>(&mut self, name: &str, work: impl FnOnce(&Progress) -> Result<T>) -> Option<T> {
        self.run(name, |progress| work(progress).map(|value| (value, Tally::PASSED)))
    }

    fn run<T>(&mut self, name: &str, work: impl FnOnce(&Progress) -> Result<(T, Tally)>) -> Option<T> {
        let label = format!("{name:.<90} ");
        if !self.has_company {
            print!("{label}");
            // An error does not matter: the name would only appear later.
            let _ = io::stdout().flush();
        }
        let (start, before) = (Instant::now(), command::processor_seconds());
        let progress = Progress::kept();
        let outcome = work(&progress);
        let (seconds, processor) = (start.elapsed().as_secs_f64(), command::processor_seconds() - before);
        let (value, tally, failure) = match outcome {
            Ok((value, tally)) => {
                let failed = format!("{} of its tests failed or were ignored", tally.failed);
                (Some(value), tally, (tally.failed > 0).then_some(failed))
            }
            Err(error) => (None, Tally::FAILED, Some(trouble::explained(&error))),
        };
        let label = if self.has_company { &*label } else { "" };
        let verdict = if failure.is_none() { "pass" } else { "FAIL" };
        let tests = if tally.passed + tally.failed == 1 { String::new() } else { format!(" ({tally})") };
        println!("{label}{verdict} {seconds:6.1} s, {processor:6.1} s CPU{tests}");
        if let Some(reason) = &failure {
            println!("{}error: {reason}\n", progress.into_text());
        }
        if let (None, Some(record)) = (&failure, &self.record) {
            let mut record = record.lock().unwrap_or_else(PoisonError::into_inner);
            if let Err(error) = record.note(name, tally) {
                println!("    {error:#}");
            }
        }
        let failure = failure.map(|reason| format!("{name}: {reason}"));
        self.done.push(Done { tally, processor, failure });
        value
    }

    /// Runs groups of steps in parallel, for steps that keep only one processor busy. Each step is
    /// reported when it has ended.
    pub fn side_by_side<const N: usize>(&mut self, groups: [Group<'_>; N]) {
        let (only, is_selective, record) = (&self.only, self.is_selective, &self.record);
        let run = |group: Group<'_>| {
            let mut suite =
                Self { has_company: true, is_selective, record: record.clone(), ..Self::new(only.clone()) };
            group(&mut suite);
            (suite.done, suite.left)
        };
        let ended = thread::scope(|scope| {
            let threads = groups.map(|group| scope.spawn(|| run(group)));
            threads.map(|thread| thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
        });
        for (done, left) in ended {
            self.done.extend(done);
            self.left.extend(left);
        }
    }

    /// Prints the failures and, as the last line, the counts.
    pub fn finish(self) -> ExitCode {
        println!();
        for failure in self.done.iter().filter_map(|done| done.failure.as_ref()) {
            println!("FAIL {failure}");
        }
        if self.record.is_some() && !self.left.is_empty() {
            println!("left on this tree, {} steps: {}", self.left.len(), self.left.join("; "));
        }
        if self.done.is_empty() {
            println!("no step matches the text of --only");
        }
        let processor: f64 = self.done.iter().map(|done| done.processor).sum();
        println!("ran for {:.0} s, {processor:.0} s of processor time", self.start.elapsed().as_secs_f64());
        let tally: Tally = self.done.iter().map(|done| done.tally).sum();
        println!("{tally}");
        if tally.failed == 0 && tally.passed > 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}

#[cfg(test)]
mod tests {
    use anyhow::bail;

    use super::*;

    /// What has been run: the sum of the tests, and the failures.
    fn sum(done: &[Done]) -> (String, Vec<&str>) {
        let tally: Tally = done.iter().map(|done| done.tally).sum();
        (tally.to_string(), done.iter().filter_map(|done| done.failure.as_deref()).collect())
    }

    #[test]
    fn steps_are_counted_after_a_failure_and_side_by_side() {
        let mut suite = Suite::new(None);
        suite.step("one", |_| bail!("broken"));
        suite.side_by_side([
            Box::new(|suite| suite.step("two", |_| Ok(()))),
            Box::new(|suite| suite.count("many", |_| Ok(Tally { passed: 5, failed: 1 }))),
        ]);
        let failures = vec!["one: broken", "many: 1 of its tests failed or were ignored"];
        assert_eq!(sum(&suite.done), ("6 passed, 2 failed".to_owned(), failures));
    }

    #[test]
    fn only_wanted_and_required_steps_run() {
        let mut suite = Suite::new(Some("camera".into()));
        suite.step("browser: the camera moves", |_| Ok(()));
        suite.step("format", |_| bail!("never run"));
        assert_eq!(suite.require("the demo is built", |_| Ok(7)), Some(7));
        assert_eq!(sum(&suite.done), ("2 passed, 0 failed".to_owned(), Vec::new()));
    }

    #[test]
    fn run_is_continued_where_it_was_interrupted() {
        let folder = tempfile::tempdir().unwrap();
        let file = || folder.path().join("full.json");
        let run = |only: Option<&str>, second: Result<()>| {
            let mut suite = Suite::new(only.map(str::to_owned)).with_record(Record::read(file()).unwrap());
            let mut ran = Vec::new();
            suite.count("many", |_| {
                ran.push("many");
                Ok(Tally { passed: 5, failed: 0 })
            });
            suite.step("second", |_| {
                ran.push("second");
                second
            });
            (ran, sum(&suite.done).0, suite.left)
        };
        let left = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        let of = |ran: &[&'static str], counts: &str, names: &[&str]| {
            (ran.to_vec(), counts.to_owned(), left(names))
        };
        assert_eq!(run(Some("many"), Ok(())), of(&["many"], "5 passed, 0 failed", &["second"]));
        assert_eq!(run(None, Err(anyhow::anyhow!("broken"))), of(&["second"], "5 passed, 1 failed", &[]));
        assert_eq!(run(None, Ok(())), of(&["second"], "6 passed, 0 failed", &[]));
        assert_eq!(run(None, Ok(())), of(&[], "6 passed, 0 failed", &[]));
        // A step that is named is run again.
        assert_eq!(run(Some("second"), Ok(())), of(&["second"], "1 passed, 0 failed", &[]));
    }
}
