//! Real browsers with three engines: Chromium, driven over the DevTools protocol, Firefox over
//! WebDriver BiDi, and WebKitGTK over WebDriver; and the timing of the demo's frames in them.
//!
//! The clients of the protocols are written here on JSON over a WebSocket or HTTP. They need only a
//! handful of the protocols' methods. A crate with all of them would take longer to compile than the
//! rest of this program, and none covers the three browsers as Debian packages them: fantoccini and
//! thirtyfour need geckodriver, Playwright needs patched browsers.

mod actions;
pub mod check;
mod chromium;
mod display;
mod firefox;
mod page;
mod probe;
mod process;
mod socket;
mod tab;
pub mod turntable;
mod webkit;

use std::fmt;

use anyhow::Result;

pub use chromium::{Chromium, WebGl};
pub use firefox::Firefox;
pub use page::Page;
pub use webkit::WebKit;

use tools::progress::Progress;

/// A running browser. Dropping it ends the browser.
pub trait Browser: fmt::Debug {
    /// Which engine it has.
    fn engine(&self) -> Engine;

    /// The browser's name and version.
    fn version(&mut self) -> Result<String>;

    /// Opens a page that shares no storage with pages of other browsers. `script` runs in the page
    /// before the page's own scripts.
    fn open(&mut self, address: &str, script: &str) -> Result<Page>;

    /// Starts a browser that has crashed again. Returns whether it had.
    fn revive(&mut self, _progress: &Progress) -> Result<bool> {
        Ok(false)
    }
}

/// A browser engine.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Engine {
    /// Blink: Chromium, Chrome, Edge.
    Chromium,
    /// Gecko.
    Firefox,
    /// Safari's, as WebKitGTK.
    WebKit,
}

impl Engine {
    /// All of them. The first is the one that tests of a single engine use.
    pub const ALL: [Self; 3] = [Self::Chromium, Self::Firefox, Self::WebKit];

    /// Starts an installed browser with this engine. As root on Debian, installs one if there is
    /// none.
    pub fn start(self, progress: &Progress) -> Result<Box<dyn Browser>> {
        Ok(match self {
            Self::Chromium => Box::new(Chromium::start(progress)?),
            Self::Firefox => Box::new(Firefox::start(progress)?),
            Self::WebKit => Box::new(WebKit::start(progress)?),
        })
    }
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Chromium => "Chromium",
            Self::Firefox => "Firefox",
            Self::WebKit => "WebKit",
        })
    }
}
