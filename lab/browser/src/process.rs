//! Starting and ending the programs of browsers.

use std::net::{Ipv4Addr, TcpListener};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, thread};

use anyhow::{Context, Result, bail, ensure};
use tempfile::TempDir;

use tools::progress::Progress;
use tools::{command, install, project};

/// Time limits for starting and ending a browser. Starting takes far less, unless the machine is
/// busy with other work.
const START: Duration = Duration::from_secs(300);
const END: Duration = Duration::from_secs(5);

/// File in a program's folder for its output.
const OUTPUT: &str = "output.txt";

/// A running program with a folder of its own. Dropping it ends the program and removes the folder.
#[derive(Debug)]
pub(super) struct Process {
    child: Child,
    // The last field: fields are dropped in order, and the program must have ended before its
    // folder is removed.
    folder: TempDir,
}

impl Process {
    /// A folder below `target`, because a sandboxed browser may have no access to `/tmp`.
    pub(super) fn folder(name: &str) -> Result<TempDir> {
        fs::create_dir_all(project::target())?;
        tempfile::Builder::new()
            .prefix(&format!("{name}-"))
            .tempdir_in(project::target())
            .with_context(|| format!("cannot make a folder for {name}"))
    }

    /// Starts a program.
    pub(super) fn start(mut command: Command, folder: TempDir) -> Result<Self> {
        let output = fs::File::create(folder.path().join(OUTPUT))?;
        command.stdin(Stdio::null()).stdout(output.try_clone()?).stderr(output);
        let child =
            command.spawn().with_context(|| format!("cannot start {}", command::describe(&command)))?;
        Ok(Self { child, folder })
    }

    /// Its folder.
    pub(super) fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Waits until `is_ready` finds what the program writes or opens once it has started.
    /// `is_ready` gets the program's folder and its output.
    pub(super) fn wait<T>(
        &mut self,
        mut is_ready: impl FnMut(&Path, &str) -> Result<Option<T>>,
    ) -> Result<T> {
        let deadline = Instant::now() + START;
        let output = || fs::read_to_string(self.folder.path().join(OUTPUT)).unwrap_or_default();
        let reason = loop {
            if let Some(ready) = is_ready(self.folder.path(), &output())? {
                return Ok(ready);
            }
            if let Some(status) = self.child.try_wait()? {
                break format!("it ended by itself ({status})");
            }
            if Instant::now() > deadline {
                break format!("it has opened no port within {START:?}");
            }
            thread::sleep(Duration::from_millis(20));
        };
        bail!("{reason}\n{}", output().trim_end())
    }

    /// Waits a short time for the program to end.
    pub(super) fn expect_end(&mut self) {
        let deadline = Instant::now() + END;
        while Instant::now() < deadline && matches!(self.child.try_wait(), Ok(None)) {
            thread::sleep(Duration::from_millis(20));
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // Killing a process that has ended is an error, which does not matter.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A port that nothing listens on, for a program that cannot choose one itself. Another program may
/// take it first.
pub(super) fn free_port() -> Result<u16> {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).context("no port is free")?;
    Ok(listener.local_addr()?.port())
}

/// The program that an environment variable names, or the first of these programs on PATH. As root
/// on Debian, installs the packages if there is none.
pub(super) fn find(
    variable: &str,
    names: &[&str],
    packages: &[&str],
    progress: &Progress,
) -> Result<PathBuf> {
    if let Some(named) = env::var_os(variable) {
        let named = PathBuf::from(named);
        ensure!(named.is_file(), "{variable} = {}: expected a program", named.display());
        return Ok(named);
    }
    install::program(names, packages, progress)
        .with_context(|| format!("the environment variable {variable} may name the program"))
}
