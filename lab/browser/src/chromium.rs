//! A headless Chromium, driven over the DevTools protocol.

mod tab;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};
use serde_json::json;

use super::display::Display;
use super::page::Page;
use super::process::{self, Process};
use super::socket::Socket;
use super::{Browser, Engine};
use tab::ChromiumTab;
use tools::progress::Progress;

const NAMES: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

const FLAGS: [&str; 13] = [
    "--headless",
    "--no-sandbox",
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

/// What draws the WebGL of pages on a machine without a GPU.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum WebGl {
    /// SwiftShader, which is a part of Chromium.
    SwiftShader,
    /// llvmpipe, which is a part of Mesa.
    Llvmpipe,
}

/// Lets Chromium draw without a GPU, as on a machine that has none.
const NO_GPU: &str = "--disable-gpu";

/// Lets Chromium draw by Mesa's OpenGL, on an X display.
const MESA: [&str; 4] =
    ["--ozone-platform=x11", "--use-gl=angle", "--use-angle=gl", "--ignore-gpu-blocklist"];

/// A running Chromium with a folder of its own. Dropping it ends the browser and removes the folder.
#[derive(Debug)]
pub struct Chromium {
    process: Process,
    devtools: Socket,
    port: u16,
    _display: Option<Display>,
}

impl Chromium {
    /// Starts the installed browser. As root on Debian, installs one if there is none.
    pub fn start(progress: &Progress) -> Result<Self> {
        Self::start_with(&[NO_GPU], None, progress)
    }

    /// Like [`start`](Self::start), with WebGL by this renderer, which is installed too.
    pub fn start_with_web_gl(web_gl: WebGl, progress: &Progress) -> Result<Self> {
        match web_gl {
            WebGl::SwiftShader => Self::start_with(&[NO_GPU, "--enable-unsafe-swiftshader"], None, progress),
            WebGl::Llvmpipe => {
                let display = Display::start(&["xvfb", "libgl1-mesa-dri"], progress)?;
                Self::start_with(&MESA, Some(display), progress)
            }
        }
    }

    /// The installed program. As root on Debian, installs one if there is none.
    pub fn program(progress: &Progress) -> Result<PathBuf> {
        process::find("CHROME", &NAMES, &["chromium"], progress)
    }

    fn start_with(flags: &[&str], display: Option<Display>, progress: &Progress) -> Result<Self> {
        let program = Self::program(progress)?;
        let profile = Process::folder("chromium")?;
        let mut command = Command::new(&program);
        command.arg(format!("--user-data-dir={}", profile.path().display())).args(FLAGS).args(flags);
        if let Some(display) = &display {
            command.envs([
                ("DISPLAY", display.name().as_str()),
                ("LIBGL_ALWAYS_SOFTWARE", "1"),
                ("GALLIUM_DRIVER", "llvmpipe"),
            ]);
        }
        let mut process = Process::start(command, profile)?;
        let connected = process.wait(|profile, _| connect(profile));
        let (port, devtools) = connected.with_context(|| format!("{} does not work", program.display()))?;
        Ok(Self { process, devtools, port, _display: display })
    }
}

impl Browser for Chromium {
    fn engine(&self) -> Engine {
        Engine::Chromium
    }

    fn version(&mut self) -> Result<String> {
        let version = self.devtools.call("Browser.getVersion", json!({}))?;
        let product = version["product"].as_str().context("Chromium does not tell its version")?;
        Ok(product.replace('/', " "))
    }

    fn open(&mut self, address: &str, script: &str) -> Result<Page> {
        let context =
            self.devtools.call("Target.createBrowserContext", json!({ "disposeOnDetach": true }))?;
        let blank = json!({ "url": "about:blank", "browserContextId": context["browserContextId"] });
        let target = self.devtools.call("Target.createTarget", blank)?;
        let target = target["targetId"].as_str().context("Chromium opened a page without a name")?;
        let devtools = Socket::connect("Chromium", self.port, &format!("/devtools/page/{target}"))?;
        ChromiumTab::visit(devtools, address, script).map(Page::new)
    }
}

impl Drop for Chromium {
    fn drop(&mut self) {
        // `Browser.close` also ends the browser's helper processes. An error does not matter: a
        // browser that does not end is killed.
        let _ = self.devtools.call("Browser.close", json!({}));
        self.process.expect_end();
    }
}

/// Connects to the port that the browser writes into its profile.
fn connect(profile: &Path) -> Result<Option<(u16, Socket)>> {
    let written = fs::read_to_string(profile.join("DevToolsActivePort")).unwrap_or_default();
    let Some((port, path)) = parse_port(&written) else { return Ok(None) };
    Ok(Some((port, Socket::connect("Chromium", port, path)?)))
}

/// The port and the path of the browser's DevTools connection, or `None` while the file is still
/// being written.
fn parse_port(written: &str) -> Option<(u16, &str)> {
    let (port, path) = written.split_once('\n')?;
    let path = path.trim_end();
    path.starts_with("/devtools/browser/").then_some((port.parse().ok()?, path))
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
