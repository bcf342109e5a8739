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

/// A step that has begun.
#[derive(Debug)]
pub struct Step<'a> {
    progress: &'a Progress,
    start: Instant,
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

    /// Begins a step; [`Step::done`] ends it.
    pub fn begin(&self, verb: &str, what: impl Display) -> Step<'_> {
        self.say(verb, what);
        Step { progress: self, start: Instant::now() }
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

impl Step<'_> {
    /// Reports how long the step took.
    pub fn done(self) {
        self.progress.say("Done", format_args!("in {:.1} s", self.start.elapsed().as_secs_f64()));
    }

    /// Reports how long the step took, and its result.
    pub fn done_with(self, result: impl Display) {
        self.progress.say("Done", format_args!("in {:.1} s: {result}", self.start.elapsed().as_secs_f64()));
    }
}
