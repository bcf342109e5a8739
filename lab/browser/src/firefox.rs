//! A headless Firefox, driven over WebDriver BiDi.

mod tab;

use std::cell::RefCell;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::rc::Rc;

use anyhow::{Context, Result};
use serde_json::{Value, json};

use super::page::Page;
use super::process::{self, Process};
use super::socket::Socket;
use super::{Browser, Engine};
use tab::FirefoxTab;
use tools::progress::Progress;

const NAMES: [&str; 2] = ["firefox-esr", "firefox"];

/// The events that pages are watched for.
const EVENTS: [&str; 4] =
    ["log.entryAdded", "network.beforeRequestSent", "network.fetchError", "network.responseCompleted"];

/// Settings that differ from those that Firefox itself chooses for tests: a page from a file may not
/// read other files, as in a visitor's browser.
const SETTINGS: &str = "user_pref('security.fileuri.strict_origin_policy', true);\n";

/// A running Firefox with a folder of its own. Dropping it ends the browser and removes the folder.
#[derive(Debug)]
pub struct Firefox {
    process: Process,
    /// The one session that Firefox has, which all pages share.
    session: Rc<RefCell<Socket>>,
    version: String,
}

impl Firefox {
    /// Starts the installed browser. As root on Debian, installs one if there is none.
    pub fn start(progress: &Progress) -> Result<Self> {
        let program = process::find("FIREFOX", &NAMES, &["firefox-esr"], progress)?;
        let profile = Process::folder("firefox")?;
        fs::write(profile.path().join("user.js"), SETTINGS)?;
        let mut command = Command::new(&program);
        command.args(["--headless", "--no-remote", "--remote-debugging-port", "0", "--profile"]);
        command.arg(profile.path()).arg("about:blank");
        let mut process = Process::start(command, profile)?;
        let connected = process.wait(|profile, _| connect(profile));
        let mut session = connected.with_context(|| format!("{} does not work", program.display()))?;
        let opened = session.call("session.new", json!({ "capabilities": {} }))?;
        let version = opened["capabilities"]["browserVersion"].as_str().context("Firefox has no version")?;
        session.call("session.subscribe", json!({ "events": EVENTS }))?;
        Ok(Self { process, session: Rc::new(RefCell::new(session)), version: format!("Firefox {version}") })
    }
}

impl Browser for Firefox {
    fn engine(&self) -> Engine {
        Engine::Firefox
    }

    fn version(&mut self) -> Result<String> {
        Ok(self.version.clone())
    }

    fn open(&mut self, address: &str, script: &str) -> Result<Page> {
        FirefoxTab::visit(Rc::clone(&self.session), address, script).map(Page::new)
    }
}

impl Drop for Firefox {
    fn drop(&mut self) {
        // `browser.close` also ends the browser's helper processes. An error does not matter: a
        // browser that does not end is killed.
        let _ = self.session.borrow_mut().call("browser.close", json!({}));
        self.process.expect_end();
    }
}

/// Connects to the port that the browser writes into its profile.
fn connect(profile: &Path) -> Result<Option<Socket>> {
    let written = fs::read_to_string(profile.join("WebDriverBiDiServer.json")).unwrap_or_default();
    let Some(port) = parse_port(&written) else { return Ok(None) };
    Socket::connect("Firefox", port, "/session").map(Some)
}

/// The port of the browser's connection, or `None` while the file is still being written.
fn parse_port(written: &str) -> Option<u16> {
    let server: Value = serde_json::from_str(written).ok()?;
    server["ws_port"].as_u64()?.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_port_is_read_once_it_is_fully_written() {
        assert_eq!(parse_port(r#"{"ws_host":"127.0.0.1","ws_port":43227}"#), Some(43227));
        for part in ["", r#"{"ws_host""#, r#"{"ws_port":70000}"#] {
            assert_eq!(parse_port(part), None, "{part:?}");
        }
    }
}
