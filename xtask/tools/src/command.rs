//! Running other programs, with their output live or captured.

use std::cell::Cell;
use std::ffi::OsStr;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Output, Stdio};
use std::{env, iter};

use anyhow::{Context, Result, ensure};
use wait4::Wait4 as _;

use crate::family::{self, Member};
use crate::project;
use crate::system::System;

/// A program that has ended.
#[derive(Debug)]
pub struct Ended {
    /// Whether it succeeded.
    pub success: bool,
    /// Its stdout and stderr, in the order of writing.
    pub output: String,
}

thread_local! {
    static PROCESSOR_SECONDS: Cell<f64> = const { Cell::new(0.0) };
}

/// The processor time, in seconds, of all programs that this thread has run to their end, with the
/// programs that they ran. Only Unix counts the latter.
pub fn processor_seconds() -> f64 {
    PROCESSOR_SECONDS.get()
}

/// Adds the processor time, in seconds, of programs that another thread has run for this one.
pub(crate) fn count_processor_seconds(seconds: f64) {
    PROCESSOR_SECONDS.set(PROCESSOR_SECONDS.get() + seconds);
}

/// Waits for the end of a program, and counts its processor time.
fn end(program: Member) -> io::Result<ExitStatus> {
    let used = program.child.wait4()?;
    count_processor_seconds((used.rusage.utime + used.rusage.stime).as_secs_f64());
    Ok(used.status)
}

/// A call, in the workspace, of the same cargo that runs this program.
pub fn cargo(words: impl IntoIterator<Item: AsRef<OsStr>>) -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(words).current_dir(project::root()).env("CARGO_TARGET_DIR", project::target());
    // `cargo run` sets variables that describe this program's package. Build scripts of another
    // cargo must not see them.
    for (name, _) in env::vars_os() {
        if name
            .to_str()
            .is_some_and(|name| name.starts_with("CARGO_PKG_") || name.starts_with("CARGO_MANIFEST_"))
        {
            command.env_remove(name);
        }
    }
    command
}

/// Runs a program and keeps what it writes to stdout and stderr, in the order of writing. `tell` also
/// receives each piece of output as it is written.
pub fn capture(mut command: Command, mut tell: impl FnMut(&str)) -> Result<Ended> {
    let name = describe(&command);
    let (mut reader, writer) = io::pipe().context("cannot make a pipe")?;
    command.stdin(Stdio::null()).stdout(writer.try_clone()?).stderr(writer);
    let child = family::start(&mut command).with_context(|| format!("cannot start {name}"))?;
    // The command holds the writing ends of the pipe. While they are open, the reading end would
    // wait for more.
    drop(command);
    let (mut output, mut part) = (Vec::new(), [0; 4096]);
    loop {
        let length = reader.read(&mut part).with_context(|| format!("cannot read what {name} writes"))?;
        if length == 0 {
            break;
        }
        tell(&String::from_utf8_lossy(&part[..length]));
        output.extend_from_slice(&part[..length]);
    }
    let status = end(child).with_context(|| format!("cannot wait for {name}"))?;
    Ok(Ended { success: status.success(), output: String::from_utf8_lossy(&output).into_owned() })
}

/// The stdout of a program that must succeed, without the final newline.
pub fn answer(command: &mut Command) -> Result<String> {
    // Its processor time is not counted: it only answers a question.
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let child = family::start(command).with_context(|| format!("cannot start {}", describe(command)))?;
    let output = told(child).with_context(|| format!("cannot wait for {}", describe(command)))?;
    let complaint = String::from_utf8_lossy(&output.stderr);
    let status = output.status;
    ensure!(status.success(), "{} failed ({status}): {}", describe(command), complaint.trim());
    Ok(String::from_utf8_lossy(&output.stdout).trim_end().to_owned())
}

/// Waits for a program that was started with pipes, and returns what it writes.
pub fn told(program: Member) -> io::Result<Output> {
    // A field that is moved out leaves the program's entry, which is dropped after this.
    let Member { child, .. } = program;
    child.wait_with_output()
}

/// The first of these programs that is found on PATH.
pub fn on_path(names: &[&str]) -> Option<PathBuf> {
    let folders: Vec<_> = env::split_paths(&env::var_os("PATH")?).collect();
    System::HERE.program(names, &folders)
}

/// The command line as one would type it, without the folder of its program.
pub fn describe(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let words = iter::once(program.file_name().unwrap_or(program.as_os_str())).chain(command.get_args());
    format!("`{}`", words.map(OsStr::to_string_lossy).collect::<Vec<_>>().join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_that_is_not_there_is_named() {
        let error = capture(Command::new("no-such-program"), |_| {}).err().unwrap();
        assert!(error.to_string().contains("no-such-program"), "{error}");
        assert_eq!(on_path(&["no-such-program"]), None);
    }
}
