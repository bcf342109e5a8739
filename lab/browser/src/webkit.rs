//! Safari's engine as WebKitGTK, driven over WebDriver, on a virtual display.

mod driver;
mod tab;

use std::cell::RefCell;
use std::fs;
use std::process::Command;
use std::rc::Rc;

use anyhow::{Context, Result, ensure};
use serde_json::json;

use super::display::Display;
use super::page::{PROBE, Page};
use super::process::{self, Process};
use super::{Browser, Engine};
use driver::Driver;
use tab::WebKitTab;
use tools::progress::Progress;
use tools::{command, install, project};

/// The display, the driver, and what the browser itself needs.
const PACKAGES: [&str; 4] = ["xvfb", "webkit2gtk-driver", "python3-gi", "gir1.2-webkit2-4.1"];

/// Debian's interpreter, whose packages those are, and the browser that it runs.
const PYTHON: &str = "/usr/bin/python3";
const HOST: &str = "lab/browser/src/webkit/host.py";

/// Succeeds if the interpreter can run the browser.
const HAS_WEBKIT: &str = "import gi; gi.require_version('WebKit2', '4.1')";

/// A running WebKitGTK with a folder of its own. Dropping it ends the browser and removes the folder.
#[derive(Debug)]
pub struct WebKit {
    driver: Rc<RefCell<Driver>>,
    version: String,
    /// Number of windows that were opened: the browser's log names them by it.
    windows: usize,
    // Dropped in this order, the display last.
    process: Process,
    _display: Display,
}

impl WebKit {
    /// Starts the installed browser. As root on Debian, installs one if there is none.
    pub fn start(progress: &Progress) -> Result<Self> {
        let has_webkit = || command::answer(Command::new(PYTHON).args(["-c", HAS_WEBKIT])).is_ok();
        if !has_webkit() && install::debian_root() {
            install::apt(&PACKAGES, progress)?;
        }
        ensure!(
            has_webkit(),
            "{PYTHON} has no WebKitGTK: install the Debian packages {}",
            PACKAGES.join(" ")
        );
        let display = Display::start(&PACKAGES, progress)?;
        let program = process::find("WEBKIT_DRIVER", &["WebKitWebDriver"], &PACKAGES, progress)?;
        let folder = Process::folder("webkit")?;
        fs::write(folder.path().join(PRELUDE), "")?;
        let port = process::free_port()?;
        let mut command = Command::new(&program);
        command.arg(format!("--port={port}"));
        command.envs([("DISPLAY", display.name().as_str()), ("GDK_BACKEND", "x11"), ("NO_AT_BRIDGE", "1")]);
        let mut process = Process::start(command, folder)?;
        let session = json!({
            "pageLoadStrategy": "eager",
            "webkitgtk:browserOptions": { "binary": PYTHON, "args": [project::root().join(HOST), process.path()] },
        });
        let driver = process.wait(|_, _| Driver::connect(port, &session));
        let driver = driver.with_context(|| format!("{} does not work", program.display()))?;
        let version = format!("WebKitGTK {}", driver.version());
        // The first window, which the session begins with, stays blank.
        Ok(Self { driver: Rc::new(RefCell::new(driver)), version, windows: 1, process, _display: display })
    }
}

/// The script that the browser runs at the start of every page of the next window.
const PRELUDE: &str = "prelude.js";

/// What has happened in the windows.
const LOG: &str = "log.jsonl";

impl Browser for WebKit {
    fn engine(&self) -> Engine {
        Engine::WebKit
    }

    fn version(&mut self) -> Result<String> {
        Ok(self.version.clone())
    }

    fn open(&mut self, address: &str, script: &str) -> Result<Page> {
        let folder = self.process.path();
        fs::write(folder.join(PRELUDE), format!("{PROBE};\n{script};\n"))?;
        let number = self.windows;
        self.windows += 1;
        let log = folder.join(LOG);
        WebKitTab::visit(Rc::clone(&self.driver), log, number, address).map(Page::new)
    }

    fn revive(&mut self, progress: &Progress) -> Result<bool> {
        let has_crashed = !self.driver.borrow_mut().has_session();
        if has_crashed {
            *self = Self::start(progress)?;
        }
        Ok(has_crashed)
    }
}

impl Drop for WebKit {
    fn drop(&mut self) {
        // An error does not matter: a browser without a driver and a display ends.
        let _ = self.driver.borrow_mut().quit();
    }
}
