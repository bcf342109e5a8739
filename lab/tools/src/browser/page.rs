//! One page in the browser: evaluates scripts in it, sends input, and records its errors.

use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail, ensure};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Value, json};

use super::devtools::{DevTools, Event};

const PROBE: &str = include_str!("probe.js");

/// The size of the window, and so of screenshots.
const WINDOW: (u32, u32) = (1440, 900);

/// How long the page may take to load and draw its first picture, on a busy machine.
const LOADING: Duration = Duration::from_secs(300);

/// An open page. Dropping it closes the page.
#[derive(Debug)]
pub struct Page {
    devtools: DevTools,
    complaints: Vec<String>,
    requests: Vec<String>,
}

impl Page {
    /// Opens an address. `script` runs before the page's own scripts.
    pub fn visit(devtools: DevTools, address: &str, script: &str) -> Result<Self> {
        let mut page = Self { devtools, complaints: Vec::new(), requests: Vec::new() };
        for domain in ["Page", "Runtime", "Network", "Log"] {
            page.devtools.call(&format!("{domain}.enable"), json!({}))?;
        }
        page.resize(WINDOW.0, WINDOW.1)?;
        for source in [PROBE, script] {
            page.devtools.call("Page.addScriptToEvaluateOnNewDocument", json!({ "source": source }))?;
        }
        let visit = page.devtools.call("Page.navigate", json!({ "url": address }))?;
        if let Some(error) = visit["errorText"].as_str() {
            bail!("the browser cannot open {address}: {error}");
        }
        Ok(page)
    }

    /// Gives the window a size in pixels.
    pub fn resize(&mut self, width: u32, height: u32) -> Result<()> {
        let window = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        self.devtools.call("Emulation.setDeviceMetricsOverride", window).map(drop)
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
        let call = json!({
            "expression": expression, "awaitPromise": true, "returnByValue": true, "userGesture": true,
        });
        let mut answer = self
            .devtools
            .call("Runtime.evaluate", call)
            .with_context(|| format!("cannot ask the page `{expression}`"))?;
        if let Some(exception) = answer.get("exceptionDetails") {
            bail!("the page threw at `{expression}`: {}", thrown(exception));
        }
        Ok(answer["result"]["value"].take())
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
        self.mouse("mousePressed", from, 1)?;
        for step in 1..=STEPS {
            let part = f64::from(step) / f64::from(STEPS);
            self.mouse("mouseMoved", (from.0 + by.0 * part, from.1 + by.1 * part), 1)?;
        }
        self.mouse("mouseReleased", (from.0 + by.0, from.1 + by.1), 0)
    }

    fn mouse(&mut self, kind: &str, at: (f64, f64), buttons: u32) -> Result<()> {
        let event = json!({
            "type": kind, "x": at.0, "y": at.1, "button": "left", "buttons": buttons, "clickCount": 1,
        });
        self.devtools.call("Input.dispatchMouseEvent", event).map(drop)
    }

    /// Turns the mouse's wheel over a point.
    pub fn wheel(&mut self, at: (f64, f64), by: f64) -> Result<()> {
        let event = json!({ "type": "mouseWheel", "x": at.0, "y": at.1, "deltaX": 0, "deltaY": by });
        self.devtools.call("Input.dispatchMouseEvent", event).map(drop)
    }

    /// Presses and releases a key that has a name and no character, such as an arrow.
    pub fn press(&mut self, key: &str, code: u32) -> Result<()> {
        for kind in ["rawKeyDown", "keyUp"] {
            let event = json!({ "type": kind, "key": key, "code": key, "windowsVirtualKeyCode": code });
            self.devtools.call("Input.dispatchKeyEvent", event)?;
        }
        Ok(())
    }

    /// Disconnects the page from the network, or connects it again.
    pub fn set_offline(&mut self, offline: bool) -> Result<()> {
        let unlimited = json!({
            "offline": offline, "latency": 0, "downloadThroughput": -1, "uploadThroughput": -1,
        });
        self.devtools.call("Network.emulateNetworkConditions", unlimited).map(drop)
    }

    /// Shows the page as to a visitor whose system forces its colours on every page.
    pub fn force_colours(&mut self) -> Result<()> {
        let features = json!({ "features": [{ "name": "forced-colors", "value": "active" }] });
        self.devtools.call("Emulation.setEmulatedMedia", features).map(drop)
    }

    /// Types a text where the focus is.
    pub fn type_text(&mut self, text: &str) -> Result<()> {
        self.devtools.call("Input.insertText", json!({ "text": text })).map(drop)
    }

    /// The page as a PNG.
    pub fn screenshot(&mut self) -> Result<Vec<u8>> {
        self.capture(json!({ "format": "png" }))
    }

    /// A part of the page as a PNG: the first element that a selector finds.
    pub fn screenshot_of(&mut self, selector: &str) -> Result<Vec<u8>> {
        let clip = self.ask(&format!("probe.place({})", json!(selector)))?;
        self.capture(json!({ "format": "png", "clip": clip }))
    }

    fn capture(&mut self, what: Value) -> Result<Vec<u8>> {
        let answer = self.devtools.call("Page.captureScreenshot", what)?;
        let data = answer["data"].as_str().context("Chromium took a screenshot without data")?;
        BASE64_STANDARD.decode(data).context("Chromium's screenshot is not base64")
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
        // Events that happened before this call have been received once it returns.
        self.ask("0")?;
        for event in self.devtools.take_events() {
            if event.method == "Network.requestWillBeSent" {
                self.requests.extend(event.params["request"]["url"].as_str().map(str::to_owned));
            } else {
                self.complaints.extend(complaint(&event));
            }
        }
        Ok(())
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        // An error does not matter: a browser that has ended has closed its pages.
        let _ = self.devtools.call("Page.close", json!({}));
    }
}

fn complaint(event: &Event) -> Option<String> {
    let params = &event.params;
    match event.method.as_str() {
        "Runtime.exceptionThrown" => Some(thrown(&params["exceptionDetails"])),
        "Runtime.consoleAPICalled" if params["type"] == "error" || params["type"] == "assert" => {
            let words = params["args"].as_array()?.iter().map(|word| match &word["value"] {
                Value::String(text) => text.clone(),
                Value::Null => word["description"].as_str().unwrap_or_default().to_owned(),
                value => value.to_string(),
            });
            Some(words.collect::<Vec<_>>().join(" "))
        }
        "Log.entryAdded" if params["entry"]["level"] == "error" => {
            let entry = &params["entry"];
            Some(format!("{} {}", entry["text"].as_str()?, entry["url"].as_str().unwrap_or_default()))
        }
        _ => None,
    }
}

fn thrown(exception: &Value) -> String {
    let description = exception["exception"]["description"].as_str();
    description.or(exception["text"].as_str()).unwrap_or("an exception without a text").to_owned()
}

/// Formats complaints as the end of a message, each on a line of its own.
pub(super) fn list(complaints: &[String]) -> String {
    complaints.iter().map(|complaint| format!("\n    {complaint}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complaint_of(method: &str, params: Value) -> Option<String> {
        complaint(&Event { method: method.to_owned(), params })
    }

    #[test]
    fn errors_are_complaints_and_messages_are_not() {
        let words = json!([{ "type": "string", "value": "no light" }, { "type": "number", "value": 3 }]);
        let error = json!({ "type": "error", "args": words });
        assert_eq!(complaint_of("Runtime.consoleAPICalled", error).as_deref(), Some("no light 3"));
        let message = json!({ "type": "log", "args": words });
        assert_eq!(complaint_of("Runtime.consoleAPICalled", message), None);
        let missing = json!({ "entry": { "level": "error", "text": "404", "url": "http://127.0.0.1/a.js" } });
        assert_eq!(complaint_of("Log.entryAdded", missing).as_deref(), Some("404 http://127.0.0.1/a.js"));
        assert_eq!(complaint_of("Page.loadEventFired", json!({})), None);
    }

    #[test]
    fn an_exception_is_told_with_its_description() {
        let exception = json!({ "text": "Uncaught", "exception": { "description": "Error: no canvas" } });
        let params = json!({ "exceptionDetails": exception });
        assert_eq!(complaint_of("Runtime.exceptionThrown", params).as_deref(), Some("Error: no canvas"));
        assert_eq!(thrown(&json!({ "text": "Uncaught 7" })), "Uncaught 7");
    }
}
