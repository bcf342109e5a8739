//! Finding, starting and ending a headless Chromium.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, thread};

use anyhow::{Context, Result, bail, ensure};
use serde_json::json;
use tempfile::TempDir;

use super::devtools::DevTools;
use super::page::Page;
use crate::progress::Progress;
use crate::{command, install, project};

const NAMES: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

const FLAGS: [&str; 14] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-dev-shm-usage",
    "--disable-sync",
    "--no-default-browser-check",
    "--no-first-run",
    "--no-proxy-server",
    // Only this machine's address is resolved, so that a page that needs the network fails at once.
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
    // The browser chooses a free port and writes it into its folder.
    "--remote-debugging-port=0",
    "about:blank",
];

/// File in the browser's folder for its stderr, which is read only if the browser does not start.
const STDERR: &str = "stderr.txt";

/// Time limits for starting and ending the browser. Starting takes far less, unless the machine is
/// busy with other work.
const START: Duration = Duration::from_secs(300);
const END: Duration = Duration::from_secs(5);

/// A running browser with a folder of its own. Dropping it ends the browser and removes the folder.
#[derive(Debug)]
pub struct Chromium {
    process: Child,
    devtools: DevTools,
    port: u16,
    // The last field: fields are dropped in order, and the browser must have ended before its
    // folder is removed.
    _profile: TempDir,
}

impl Chromium {
    /// Starts the installed browser. As root on Debian, installs one if there is none.
    pub fn start(progress: &Progress) -> Result<Self> {
        let program = find(progress)?;
        // Below target, because a sandboxed browser may have no access to /tmp.
        fs::create_dir_all(project::target())?;
        let profile = tempfile::Builder::new()
            .prefix("chromium-")
            .tempdir_in(project::target())
            .context("cannot make a folder for Chromium's profile")?;
        let mut process = Command::new(&program)
            .arg(format!("--user-data-dir={}", profile.path().display()))
            .args(FLAGS)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(fs::File::create(profile.path().join(STDERR))?)
            .spawn()
            .with_context(|| format!("cannot start {}", program.display()))?;
        match connect(&mut process, profile.path()) {
            Ok((port, devtools)) => Ok(Self { process, devtools, port, _profile: profile }),
            Err(error) => {
                end(&mut process);
                let said = fs::read_to_string(profile.path().join(STDERR)).unwrap_or_default();
                bail!("{} does not work: {error:#}\n{}", program.display(), said.trim_end())
            }
        }
    }

    /// The browser's name and version.
    pub fn version(&mut self) -> Result<String> {
        let version = self.devtools.call("Browser.getVersion", json!({}))?;
        let product = version["product"].as_str().context("Chromium does not tell its version")?;
        Ok(product.replace('/', " "))
    }

    /// Opens a page with a profile of its own. `script` runs in the page before the page's own
    /// scripts.
    pub fn open(&mut self, address: &str, script: &str) -> Result<Page> {
        let context =
            self.devtools.call("Target.createBrowserContext", json!({ "disposeOnDetach": true }))?;
        let blank = json!({ "url": "about:blank", "browserContextId": context["browserContextId"] });
        let target = self.devtools.call("Target.createTarget", blank)?;
        let target = target["targetId"].as_str().context("Chromium opened a page without a name")?;
        let devtools = DevTools::connect(self.port, &format!("/devtools/page/{target}"))?;
        Page::visit(devtools, address, script)
    }
}

impl Drop for Chromium {
    fn drop(&mut self) {
        // `Browser.close` also ends the browser's helper processes. An error does not matter: a
        // browser that does not end is killed.
        let _ = self.devtools.call("Browser.close", json!({}));
        end(&mut self.process);
    }
}

fn find(progress: &Progress) -> Result<PathBuf> {
    if let Some(chrome) = env::var_os("CHROME") {
        let chrome = PathBuf::from(chrome);
        ensure!(chrome.is_file(), "CHROME is set to {}, where no browser is", chrome.display());
        return Ok(chrome);
    }
    if let Some(program) = command::on_path(&NAMES) {
        return Ok(program);
    }
    if install::debian_root() {
        install::apt(&["chromium"], progress)?;
    }
    command::on_path(&NAMES).with_context(|| {
        format!(
            "no browser found: install Chromium or Chrome (as one of {} on PATH), \
             or let the environment variable CHROME name it",
            NAMES.join(", ")
        )
    })
}

/// Waits for the browser to write down its port, and connects.
fn connect(process: &mut Child, profile: &Path) -> Result<(u16, DevTools)> {
    let deadline = Instant::now() + START;
    while Instant::now() < deadline {
        if let Some(status) = process.try_wait()? {
            bail!("it ended by itself ({status})");
        }
        let written = fs::read_to_string(profile.join("DevToolsActivePort")).unwrap_or_default();
        if let Some((port, path)) = parse_port(&written) {
            return Ok((port, DevTools::connect(port, path)?));
        }
        thread::sleep(Duration::from_millis(20));
    }
    bail!("it has not opened its port for DevTools within {START:?}");
}

/// The port and the path of the browser's DevTools connection, or `None` while the file is still
/// being written.
fn parse_port(written: &str) -> Option<(u16, &str)> {
    let (port, path) = written.split_once('\n')?;
    let path = path.trim_end();
    path.starts_with("/devtools/browser/").then_some((port.parse().ok()?, path))
}

/// Waits a short time for the browser to end, then kills it.
fn end(process: &mut Child) {
    let deadline = Instant::now() + END;
    while Instant::now() < deadline && matches!(process.try_wait(), Ok(None)) {
        thread::sleep(Duration::from_millis(20));
    }
    // Killing a process that has ended is an error, which does not matter.
    let _ = process.kill();
    let _ = process.wait();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_port_is_read_once_it_is_fully_written() {
        let whole = "38415\n/devtools/browser/93a6fe1e-a04b";
        assert_eq!(parse_port(whole), Some((38415, "/devtools/browser/93a6fe1e-a04b")));
        for part in ["", "384", "38415\n", "38415\n/devtools"] {
            assert_eq!(parse_port(part), None, "{part:?}");
        }
    }
}
