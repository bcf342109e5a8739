//! Running firmware in QEMU, with the counter loaded.

use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};
use std::{fs, io};

use anyhow::{Context, Result, bail};

use super::board::Board;
use super::package;
use tools::command;
use tools::progress::Progress;

/// Upper bound of the run time of firmware on a busy machine. Without it a crashed processor would
/// loop for ever.
const PATIENCE: Duration = Duration::from_secs(600);

/// A QEMU program with the arguments that select a board.
#[derive(Debug)]
pub(crate) struct Emulator {
    program: PathBuf,
    machine: &'static [&'static str],
    /// Major and minor.
    version: (u32, u32),
}

impl Emulator {
    /// Finds the emulator of a board. As root on Debian, installs it if it is missing.
    pub(crate) fn find(board: &Board, progress: &Progress) -> Result<Self> {
        let program = package::program(board.emulator, progress)?;
        let answer = command::answer(Command::new(&program).arg("--version"))?;
        let version =
            version(&answer).with_context(|| format!("cannot tell QEMU's version from: {answer}"))?;
        Ok(Self { program, machine: board.machine, version })
    }

    /// QEMU's version and the board, as in `QEMU 7.2, -M microbit`.
    pub(crate) fn describe(&self) -> String {
        let (major, minor) = self.version;
        format!("QEMU {major}.{minor}, {}", self.machine.join(" "))
    }

    /// Whether this QEMU requires version 3 of the plugin interface, as 9.1 and later do.
    pub(crate) fn wants_api_3(&self) -> bool {
        self.version >= (9, 1)
    }

    /// Runs firmware with the counter loaded. The counter writes to the file `counts`. Returns what
    /// the firmware prints.
    pub(crate) fn run(&self, firmware: &Path, counter: &Path, counts: &Path) -> Result<String> {
        // The file of an earlier run must not pass for that of this run.
        match fs::remove_file(counts) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                return Err(error).with_context(|| format!("cannot remove {}", counts.display()));
            }
            _ => {}
        }
        let mut qemu = self.command(firmware);
        // In a list of options QEMU expects each comma of a path doubled.
        let path = |path: &Path| path.display().to_string().replace(',', ",,");
        qemu.arg("-plugin").arg(format!("{},out={}", path(counter), path(counts)));
        output(qemu)
    }

    /// Runs firmware without a counter, in a folder whose files it may read. Returns what the
    /// firmware prints.
    pub(crate) fn run_in(&self, folder: &Path, firmware: &Path) -> Result<String> {
        let mut qemu = self.command(firmware);
        qemu.current_dir(folder);
        output(qemu)
    }

    /// Runs firmware whose library of C writes single letters to the console, as picolibc does. Returns
    /// what the firmware prints. Without a device for the console, QEMU writes letters to its standard
    /// error.
    pub(crate) fn run_on_console(&self, firmware: &Path) -> Result<String> {
        let mut qemu = self.command_with(firmware, ",chardev=console");
        qemu.args(["-chardev", "stdio,id=console"]);
        output(qemu)
    }

    fn command(&self, firmware: &Path) -> Command {
        self.command_with(firmware, "")
    }

    /// A command with more settings of semihosting.
    fn command_with(&self, firmware: &Path, settings: &str) -> Command {
        let mut qemu = Command::new(&self.program);
        qemu.args(self.machine).args(["-nographic", "-monitor", "none", "-serial", "none"]);
        qemu.arg("-semihosting-config").arg(format!("enable=on,target=native{settings}"));
        qemu.arg("-kernel").arg(firmware);
        qemu
    }
}

/// Returns what firmware prints, once QEMU has exited with success.
fn output(mut qemu: Command) -> Result<String> {
    qemu.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let name = command::describe(&qemu);
    let mut child = qemu.spawn().with_context(|| format!("cannot start {name}"))?;
    // A printed picture is larger than a pipe's buffer, so threads read the pipes while QEMU runs.
    let (output, complaint) = (text(child.stdout.take()), text(child.stderr.take()));
    let status = wait(&mut child).with_context(|| format!("{name} does not end"))?;
    let (output, complaint) = (join(output), join(complaint));
    if !status.success() {
        bail!("{name} failed ({status}): {}{}", output?, complaint?);
    }
    output
}

/// Waits until the process ends, at most for [`PATIENCE`].
fn wait(child: &mut Child) -> Result<ExitStatus> {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(status);
        }
        if start.elapsed() > PATIENCE {
            child.kill()?;
            child.wait()?;
            bail!("stopped it after {} s", PATIENCE.as_secs());
        }
        thread::sleep(Duration::from_millis(5));
    }
}

/// Starts a thread that reads a pipe to its end.
fn text(pipe: Option<impl Read + Send + 'static>) -> JoinHandle<io::Result<String>> {
    thread::spawn(|| {
        let mut text = String::new();
        if let Some(mut pipe) = pipe {
            pipe.read_to_string(&mut text)?;
        }
        Ok(text)
    })
}

fn join(text: JoinHandle<io::Result<String>>) -> Result<String> {
    let text = text.join().ok().context("the reader of a pipe has panicked")?;
    text.context("cannot read what QEMU printed")
}

/// The version in `QEMU emulator version 7.2.22 (Debian …)`.
fn version(answer: &str) -> Option<(u32, u32)> {
    let (_, version) = answer.lines().next()?.split_once("version ")?;
    let mut numbers = version.split(|c: char| !c.is_ascii_digit()).map_while(|number| number.parse().ok());
    Some((numbers.next()?, numbers.next()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_version_is_read_with_and_without_a_distribution() {
        let debian = "QEMU emulator version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18)\nCopyright (c) 2003-2022\n";
        assert_eq!(version(debian), Some((7, 2)));
        assert_eq!(version("QEMU emulator version 10.1.0"), Some((10, 1)));
        assert_eq!(version("qemu-system-arm: not a version"), None);
    }
}
