//! One page in a browser: evaluates scripts in it, sends input, and records its errors.

use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail, ensure};
use serde_json::{Value, json};

use super::tab::{Clip, Happened, Tab};

/// The script that runs in every page before the page's own.
pub(super) const PROBE: &str = include_str!("probe.js");

/// The size of the window, and so of screenshots.
pub(super) const WINDOW: (u32, u32) = (1440, 900);

/// How long the page may take to load and draw its first picture, on a busy machine.
const LOADING: Duration = Duration::from_secs(300);

/// An open page. Dropping it closes the page.
#[derive(Debug)]
pub struct Page {
    tab: Box<dyn Tab>,
    complaints: Vec<String>,
    requests: Vec<String>,
}

impl Page {
    pub(super) fn new(tab: Box<dyn Tab>) -> Self {
        Self { tab, complaints: Vec::new(), requests: Vec::new() }
    }

    /// Gives the window a size in pixels, each of which is one pixel of the device.
    pub fn resize(&mut self, width: u32, height: u32) -> Result<()> {
        self.resize_on(width, height, 1.0)
    }

    /// Gives the window a size in CSS pixels, on a device with this many pixels along each of them.
    pub fn resize_on(&mut self, width: u32, height: u32, density: f64) -> Result<()> {
        self.tab.resize(width, height, density)
    }

    /// Waits until the page has loaded. Returns `ready` or `failed`.
    pub fn state(&mut self) -> Result<String> {
        let deadline = Instant::now() + LOADING;
        loop {
            match self.ask("document.body?.dataset.state")?.as_str() {
                Some("loading") | None => {}
                Some(state) => return Ok(state.to_owned()),
            }
            if Instant::now() > deadline {
                let complaints = self.complaints()?;
                bail!("the page is still loading after {LOADING:?}{}", list(&complaints));
            }
            thread::sleep(Duration::from_millis(20));
        }
    }

    /// Waits until the page is ready to be used.
    pub fn ready(&mut self) -> Result<()> {
        match self.state()?.as_str() {
            "ready" => Ok(()),
            state => {
                let reason = self.ask("document.getElementById('failure')?.textContent.trim()")?;
                let reason = reason.as_str().unwrap_or("without a message in #failure");
                let complaints = self.complaints()?;
                bail!("the page is {state}: {reason}{}", list(&complaints))
            }
        }
    }

    /// The value of a JavaScript expression, which may be a promise.
    pub fn ask(&mut self, expression: &str) -> Result<Value> {
        self.tab.evaluate(expression).with_context(|| format!("the page has no answer to `{expression}`"))
    }

    /// The value of an expression that is a number.
    pub fn number(&mut self, expression: &str) -> Result<f64> {
        let value = self.ask(expression)?;
        value.as_f64().with_context(|| format!("`{expression}` is {value}, not a number"))
    }

    /// The value of an expression that is a text.
    pub fn text(&mut self, expression: &str) -> Result<String> {
        let value = self.ask(expression)?;
        Ok(value.as_str().with_context(|| format!("`{expression}` is {value}, not a text"))?.to_owned())
    }

    /// The value of an expression that is true or false.
    pub fn holds(&mut self, expression: &str) -> Result<bool> {
        let value = self.ask(expression)?;
        value.as_bool().with_context(|| format!("`{expression}` is {value}, neither true nor false"))
    }

    /// Presses the mouse's main button at a point, moves it along, and lets go.
    pub fn drag(&mut self, from: (f64, f64), by: (f64, f64)) -> Result<()> {
        const STEPS: u32 = 8;
        let point = |step| {
            let part = f64::from(step) / f64::from(STEPS);
            (from.0 + by.0 * part, from.1 + by.1 * part)
        };
        self.tab.drag(&(0..=STEPS).map(point).collect::<Vec<_>>())
    }

    /// Turns the mouse's wheel over a point.
    pub fn wheel(&mut self, at: (f64, f64), by: f64) -> Result<()> {
        self.tab.wheel(at, by)
    }

    /// Presses and releases a key that has a name and no character, such as an arrow.
    pub fn press(&mut self, key: &str, code: u32) -> Result<()> {
        self.tab.press(key, code)
    }

    /// Types a text where the focus is.
    pub fn type_text(&mut self, text: &str) -> Result<()> {
        self.tab.type_text(text)
    }

    /// Disconnects the page from the network, or connects it again.
    pub fn set_offline(&mut self, offline: bool) -> Result<()> {
        self.tab.set_offline(offline)
    }

    /// Shows the page as to a visitor whose system forces its colours on every page.
    pub fn force_colours(&mut self) -> Result<()> {
        self.tab.force_colours()
    }

    /// The page as a PNG.
    pub fn screenshot(&mut self) -> Result<Vec<u8>> {
        self.tab.capture(None)
    }

    /// A part of the page as a PNG: the first element that a selector finds, and a margin around it
    /// in pixels.
    pub fn screenshot_of(&mut self, selector: &str, margin: u32) -> Result<Vec<u8>> {
        let place = self.ask(&format!("probe.place({}, {margin})", json!(selector)))?;
        let side = |name: &str| place[name].as_f64().with_context(|| format!("{selector} has no {name}"));
        let clip = Clip { x: side("x")?, y: side("y")?, width: side("width")?, height: side("height")? };
        self.tab.capture(Some(clip))
    }

    /// Calls a method of the DevTools protocol, which only Chromium has.
    pub fn devtools(&mut self, method: &str, params: Value) -> Result<Value> {
        self.tab.devtools(method, params)
    }

    /// Runs `act`. Returns the processor time in milliseconds of each task of the page's main thread
    /// in the meantime, which other work of the machine does not lengthen. Only Chromium records it.
    pub fn tasks(&mut self, act: impl FnOnce(&mut Self) -> Result<()>) -> Result<Vec<f64>> {
        self.tab.record_tasks()?;
        act(self)?;
        self.tab.recorded_tasks()
    }

    /// Returns the addresses of all requests that the page has made.
    pub fn requests(&mut self) -> Result<&[String]> {
        self.sort_events()?;
        Ok(&self.requests)
    }

    /// Errors on the console, exceptions that nobody caught, and files that could not be loaded.
    pub fn complaints(&mut self) -> Result<Vec<String>> {
        self.sort_events()?;
        Ok(self.complaints.clone())
    }

    /// Fails if the page has complained of anything.
    pub fn must_be_content(&mut self) -> Result<()> {
        let complaints = self.complaints()?;
        ensure!(complaints.is_empty(), "the console has errors{}", list(&complaints));
        Ok(())
    }

    fn sort_events(&mut self) -> Result<()> {
        for event in self.tab.happened()? {
            match event {
                Happened::Request(address) => self.requests.push(address),
                Happened::Complaint(words) => self.complaints.push(words),
            }
        }
        Ok(())
    }
}

/// Formats complaints as the end of a message, each on a line of its own.
pub(super) fn list(complaints: &[String]) -> String {
    complaints.iter().map(|complaint| format!("\n    {complaint}")).collect()
}
