//! Reporting the progress of long work.

use std::cell::RefCell;
use std::fmt::Display;
use std::io;
use std::process::Command;
use std::time::Instant;

use anyhow::{Result, ensure};

use crate::command::{self, Ended};

/// Where progress is written: to stderr as it happens, or into a text that is shown only if
/// something fails.
#[derive(Debug)]
pub enum Progress {
    /// To stderr.
    Live,
    /// Into a text.
    Kept(RefCell<String>),
}

impl Progress {
    /// Progress that is kept in memory and not printed.
    pub fn kept() -> Self {
        Self::Kept(RefCell::default())
    }

    /// The text that was kept; empty for `Live`.
    pub fn into_text(self) -> String {
        match self {
            Self::Live => String::new(),
            Self::Kept(text) => text.into_inner(),
        }
    }

    /// Writes a line in the layout of cargo's own messages, so that it lines up with them.
    pub fn say(&self, verb: &str, what: impl Display) {
        self.quote(&format!("{verb:>12} {what}\n"));
    }

    fn quote(&self, text: &str) {
        match self {
            Self::Live => eprint!("{text}"),
            Self::Kept(kept) => kept.borrow_mut().push_str(text),
        }
    }

    /// Does some work between two lines: what it is, and how long it took.
    pub fn timed<T>(&self, verb: &str, what: impl Display, work: impl FnOnce() -> Result<T>) -> Result<T> {
        self.say(verb, what);
        let start = Instant::now();
        let result = work()?;
        self.say("Done", format_args!("in {:.1} s", start.elapsed().as_secs_f64()));
        Ok(result)
    }

    /// Runs a program that must succeed. Its output is part of the progress, and keeps its colours on a
    /// terminal.
    pub fn run(&self, mut command: Command) -> Result<()> {
        match self {
            // Stdout is reserved for results.
            Self::Live => command::run(command.stdout(io::stderr())),
            Self::Kept(_) => self.output(command).map(drop),
        }
    }

    /// Runs a program that must succeed. Returns its output, which is part of the progress.
    pub fn output(&self, command: Command) -> Result<String> {
        let name = command::describe(&command);
        let ended = self.capture(command)?;
        ensure!(ended.success, "{name} failed");
        Ok(ended.output)
    }

    /// Runs a program that may fail. Its output is part of the progress.
    pub fn capture(&self, command: Command) -> Result<Ended> {
        command::capture(command, |text| self.quote(text))
    }
}
