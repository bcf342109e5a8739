//! A virtual X display, for programs that draw nothing without a display.

use std::process::Command;

use anyhow::{Context, Result};

use super::process::{self, Process};
use tools::progress::Progress;

/// A running X server that shows nothing. Dropping it ends the server.
#[derive(Debug)]
pub(super) struct Display {
    number: u32,
    _server: Process,
}

impl Display {
    /// Starts a server on a free display. As root on Debian, installs the packages if there is none.
    pub(super) fn start(packages: &[&str], progress: &Progress) -> Result<Self> {
        let mut server = Command::new(process::find("XVFB", &["Xvfb"], packages, progress)?);
        server.args(["-displayfd", "1", "-screen", "0", "2560x1600x24", "-nolisten", "tcp"]);
        let mut server = Process::start(server, Process::folder("xvfb")?)?;
        let number = server.wait(|_, output| Ok(number(output))).context("Xvfb does not work")?;
        Ok(Self { number, _server: server })
    }

    /// What the environment variable `DISPLAY` calls it.
    pub(super) fn name(&self) -> String {
        format!(":{}", self.number)
    }
}

/// The number of the display that Xvfb writes, or `None` while it has not written it.
fn number(output: &str) -> Option<u32> {
    output.strip_suffix('\n')?.lines().last()?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_display_is_read_once_it_is_fully_written() {
        assert_eq!(number("12\n"), Some(12));
        assert_eq!(number("a warning\n7\n"), Some(7));
        for part in ["", "1", "warning\n"] {
            assert_eq!(number(part), None, "{part:?}");
        }
    }
}
