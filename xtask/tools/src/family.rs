//! The programs that this one has started: with it they end.
//!
//! cargo that is ended leaves its compilers running, and a test its browser. On Unix, therefore, every
//! program has a process group of its own, with what it starts itself, and a signal that ends this
//! program ends the groups. On Windows, Ctrl+C reaches all programs of a console without help.

use std::collections::BTreeSet;
use std::io;
use std::process::{Child, Command};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The numbers of the programs that run. While it is locked, none is started.
static RUNNING: Mutex<BTreeSet<u32>> = Mutex::new(BTreeSet::new());

fn running() -> MutexGuard<'static, BTreeSet<u32>> {
    RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A program that runs, and ends with this one.
#[derive(Debug)]
pub struct Member {
    /// The program.
    pub child: Child,
    _entry: Entry,
}

/// The number of a program that runs, until its end has been waited for.
#[derive(Debug)]
struct Entry(u32);

impl Drop for Entry {
    fn drop(&mut self) {
        running().remove(&self.0);
    }
}

/// Starts a program.
pub fn start(command: &mut Command) -> io::Result<Member> {
    let mut running = running();
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(command, 0);
    let child = command.spawn()?;
    running.insert(child.id());
    Ok(Member { _entry: Entry(child.id()), child })
}

/// Lets SIGINT, SIGTERM and SIGHUP end this program with all that it has started.
#[cfg(unix)]
pub fn end_together() -> anyhow::Result<()> {
    use anyhow::Context as _;
    use nix::sys::signal::{Signal, killpg};
    use nix::unistd::Pid;

    let end = || {
        // Kept until the end, so that nothing is started any more.
        let running = running();
        for group in running.iter().filter_map(|&id| i32::try_from(id).ok()) {
            // An error does not matter: the group may have ended just now.
            let _ = killpg(Pid::from_raw(group), Signal::SIGTERM);
        }
        std::process::exit(ENDED);
    };
    ctrlc::set_handler(end).context("cannot wait for signals")
}

/// The code by which a shell says that Ctrl+C has ended a program.
#[cfg(unix)]
const ENDED: i32 = 130;

/// Does nothing: a console's programs end together.
#[cfg(not(unix))]
pub fn end_together() -> anyhow::Result<()> {
    Ok(())
}
