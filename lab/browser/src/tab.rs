//! What a page needs of its browser.

use std::fmt;

use anyhow::{Result, bail};
use serde_json::Value;

/// A rectangle of a page, in whole pixels.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Clip {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) width: f64,
    pub(super) height: f64,
}

/// One page, in the browser's own protocol. Dropping it closes the page.
pub(super) trait Tab: fmt::Debug {
    /// The value of a JavaScript expression; a promise is awaited. An exception is an error.
    fn evaluate(&mut self, expression: &str) -> Result<Value>;

    /// Gives the page a size in pixels.
    fn resize(&mut self, width: u32, height: u32, density: f64) -> Result<()>;

    /// Presses the mouse's main button at the first point, moves along the others, and lets go.
    fn drag(&mut self, along: &[(f64, f64)]) -> Result<()>;

    /// Turns the mouse's wheel over a point.
    fn wheel(&mut self, at: (f64, f64), by: f64) -> Result<()>;

    /// Presses and releases a key that has a name and no character.
    fn press(&mut self, key: &str, code: u32) -> Result<()>;

    /// Types a text where the focus is.
    fn type_text(&mut self, text: &str) -> Result<()>;

    /// The page, or a part of it, as a PNG.
    fn capture(&mut self, clip: Option<Clip>) -> Result<Vec<u8>>;

    /// Disconnects the page from the network, or connects it again.
    fn set_offline(&mut self, offline: bool) -> Result<()>;

    /// Shows the page as to a visitor whose system forces its colours on every page.
    fn force_colours(&mut self) -> Result<()>;

    /// Calls a method of the DevTools protocol, which only Chromium has.
    fn devtools(&mut self, method: &str, _params: Value) -> Result<Value> {
        bail!("{method}: only Chromium has the DevTools protocol")
    }

    /// Starts to record the tasks of the page's main thread. Only Chromium does.
    fn record_tasks(&mut self) -> Result<()> {
        bail!("only Chromium records tasks")
    }

    /// Ends the recording. Returns the processor time of each task, in milliseconds.
    fn recorded_tasks(&mut self) -> Result<Vec<f64>> {
        bail!("only Chromium records tasks")
    }

    /// What has happened since the last call.
    fn happened(&mut self) -> Result<Vec<Happened>>;
}

/// Something that happened in a page.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Happened {
    /// It requested this address.
    Request(String),
    /// An error on the console, an exception that nobody caught, or a file that could not be loaded.
    Complaint(String),
}
