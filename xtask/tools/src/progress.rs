//! Reporting the progress of long work.

use std::cell::RefCell;
use std::env;
use std::fmt::Display;
use std::io::{self, IsTerminal as _};
use std::panic::resume_unwind;
use std::process::Command;
use std::thread;
use std::time::Instant;

use anyhow::{Result, bail};

use crate::command::{self, Ended};
use crate::system::System;
use crate::trouble;

/// Settings of cargo for a terminal that it does not see. A bar of this width fits any.
const ON_A_TERMINAL: [(&str, &str); 3] = [
    ("CARGO_TERM_COLOR", "always"),
    ("CARGO_TERM_PROGRESS_WHEN", "always"),
    ("CARGO_TERM_PROGRESS_WIDTH", "72"),
];

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

    /// Runs a program that must succeed. Its output is part of the progress, and cargo's keeps colours and
    /// bar on a terminal.
    pub fn run(&self, mut command: Command) -> Result<()> {
        // The output goes through this program, which reads why it failed, so that cargo sees no terminal.
        if matches!(self, Self::Live) && io::stderr().is_terminal() {
            let is_free = |name: &str| env::var_os(name).is_none();
            let is_wanted = |name: &str| is_free(name) && (name != ON_A_TERMINAL[0].0 || is_free("NO_COLOR"));
            command.envs(ON_A_TERMINAL.into_iter().filter(|(name, _)| is_wanted(name)));
        }
        self.output(command).map(drop)
    }

    /// Runs a program that must succeed. Returns its output, which is part of the progress. An error names
    /// the program, and the remedy for a trouble that is not its own.
    pub fn output(&self, command: Command) -> Result<String> {
        let name = command::describe(&command);
        let ended = self.capture(command)?;
        if !ended.success {
            let remedy = trouble::remedy(&ended.output, System::HERE);
            bail!("{name} failed{}", remedy.map_or_else(String::new, |remedy| format!(": {remedy}")));
        }
        Ok(ended.output)
    }

    /// Runs a few programs at once, which must succeed. Returns their outputs, which are part of the progress in the
    /// order of the programs. The system divides its processors: a queue would leave one idle while the last runs.
    pub fn outputs(&self, commands: Vec<Command>) -> Result<Vec<String>> {
        let run = |command| {
            let progress = Self::kept();
            let output = progress.output(command);
            (output, progress.into_text(), command::processor_seconds())
        };
        let ended: Vec<_> = thread::scope(|scope| {
            let threads: Vec<_> =
                commands.into_iter().map(|command| scope.spawn(move || run(command))).collect();
            let join = |thread: thread::ScopedJoinHandle<'_, _>| {
                thread.join().unwrap_or_else(|panic| resume_unwind(panic))
            };
            threads.into_iter().map(join).collect()
        });
        for (_, text, seconds) in &ended {
            self.quote(text);
            command::count_processor_seconds(*seconds);
        }
        ended.into_iter().map(|(output, ..)| output).collect()
    }

    /// Runs a program that may fail. Its output is part of the progress.
    pub fn capture(&self, command: Command) -> Result<Ended> {
        command::capture(command, |text| self.quote(text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outputs_have_the_order_of_the_programs_and_a_failure_is_named() {
        let run = |words: &[&str]| {
            let progress = Progress::kept();
            let outputs = progress.outputs(words.iter().map(|word| command::cargo([*word])).collect());
            (outputs, progress.into_text())
        };
        let (outputs, text) = run(&["help", "--version", "--list"]);
        let outputs = outputs.unwrap();
        assert_eq!(outputs.concat(), text);
        assert!(outputs[1].starts_with("cargo 1."), "{}", outputs[1]);
        let (outputs, text) = run(&["--version", "--no-such-option", "--version"]);
        let error = outputs.unwrap_err().to_string();
        assert!(
            error.contains("--no-such-option") && text.matches("cargo 1.").count() == 2,
            "{error}\n{text}"
        );
    }
}
