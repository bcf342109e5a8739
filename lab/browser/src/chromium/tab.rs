//! One page of Chromium.

use std::collections::BTreeSet;
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result, bail};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Value, json};

use crate::page::PROBE;
use crate::socket::{Event, Socket};
use crate::tab::{Clip, Happened, Tab};

/// What a trace calls a task.
const TASK: &str = "ThreadControllerImpl::RunTask";

/// A page with a connection of its own.
#[derive(Debug)]
pub(super) struct ChromiumTab {
    devtools: Socket,
}

impl ChromiumTab {
    /// Opens an address. `script` runs before the page's own scripts.
    pub(super) fn visit(devtools: Socket, address: &str, script: &str) -> Result<Box<dyn Tab>> {
        let mut tab = Self { devtools };
        for domain in ["Page", "Runtime", "Network", "Log"] {
            tab.devtools.call(&format!("{domain}.enable"), json!({}))?;
        }
        for source in [PROBE, script] {
            tab.devtools.call("Page.addScriptToEvaluateOnNewDocument", json!({ "source": source }))?;
        }
        let (width, height) = crate::page::WINDOW;
        tab.resize(width, height, 1.0)?;
        let visit = tab.devtools.call("Page.navigate", json!({ "url": address }))?;
        if let Some(error) = visit["errorText"].as_str() {
            bail!("the browser cannot open {address}: {error}");
        }
        Ok(Box::new(tab))
    }

    fn mouse(&mut self, kind: &str, at: (f64, f64), buttons: u32) -> Result<()> {
        let event = json!({
            "type": kind, "x": at.0, "y": at.1, "button": "left", "buttons": buttons, "clickCount": 1,
        });
        self.devtools.call("Input.dispatchMouseEvent", event).map(drop)
    }
}

impl Tab for ChromiumTab {
    fn evaluate(&mut self, expression: &str) -> Result<Value> {
        let call = json!({
            "expression": expression, "awaitPromise": true, "returnByValue": true, "userGesture": true,
        });
        let mut answer = self.devtools.call("Runtime.evaluate", call)?;
        if let Some(exception) = answer.get("exceptionDetails") {
            bail!("the page threw {}", thrown(exception));
        }
        Ok(answer["result"]["value"].take())
    }

    fn resize(&mut self, width: u32, height: u32, density: f64) -> Result<()> {
        let window =
            json!({ "width": width, "height": height, "deviceScaleFactor": density, "mobile": false });
        self.devtools.call("Emulation.setDeviceMetricsOverride", window).map(drop)
    }

    fn drag(&mut self, along: &[(f64, f64)]) -> Result<()> {
        let (Some(first), Some(last)) = (along.first(), along.last()) else { return Ok(()) };
        self.mouse("mousePressed", *first, 1)?;
        for point in &along[1..] {
            self.mouse("mouseMoved", *point, 1)?;
        }
        self.mouse("mouseReleased", *last, 0)
    }

    fn wheel(&mut self, at: (f64, f64), by: f64) -> Result<()> {
        let event = json!({ "type": "mouseWheel", "x": at.0, "y": at.1, "deltaX": 0, "deltaY": by });
        self.devtools.call("Input.dispatchMouseEvent", event).map(drop)
    }

    fn press(&mut self, key: &str, code: u32) -> Result<()> {
        for kind in ["rawKeyDown", "keyUp"] {
            let event = json!({ "type": kind, "key": key, "code": key, "windowsVirtualKeyCode": code });
            self.devtools.call("Input.dispatchKeyEvent", event)?;
        }
        Ok(())
    }

    fn type_text(&mut self, text: &str) -> Result<()> {
        self.devtools.call("Input.insertText", json!({ "text": text })).map(drop)
    }

    fn capture(&mut self, clip: Option<Clip>) -> Result<Vec<u8>> {
        let mut what = json!({ "format": "png" });
        if let Some(Clip { x, y, width, height }) = clip {
            what["clip"] = json!({ "x": x, "y": y, "width": width, "height": height, "scale": 1 });
        }
        let answer = self.devtools.call("Page.captureScreenshot", what)?;
        let data = answer["data"].as_str().context("Chromium took a screenshot without data")?;
        BASE64_STANDARD.decode(data).context("Chromium's screenshot is not base64")
    }

    fn set_offline(&mut self, offline: bool) -> Result<()> {
        let unlimited = json!({
            "offline": offline, "latency": 0, "downloadThroughput": -1, "uploadThroughput": -1,
        });
        self.devtools.call("Network.emulateNetworkConditions", unlimited).map(drop)
    }

    fn force_colours(&mut self) -> Result<()> {
        let features = json!({ "features": [{ "name": "forced-colors", "value": "active" }] });
        self.devtools.call("Emulation.setEmulatedMedia", features).map(drop)
    }

    fn devtools(&mut self, method: &str, params: Value) -> Result<Value> {
        self.devtools.call(method, params)
    }

    fn record_tasks(&mut self) -> Result<()> {
        let config = json!({ "traceConfig": { "includedCategories": ["toplevel"] } });
        self.devtools.call("Tracing.start", config).map(drop)
    }

    fn recorded_tasks(&mut self) -> Result<Vec<f64>> {
        self.devtools.call("Tracing.end", json!({}))?;
        let mut trace = Vec::new();
        loop {
            // The answer comes after the events before it.
            self.evaluate("0")?;
            let (traced, others) = self
                .devtools
                .take_events()
                .into_iter()
                .partition(|event| event.method.starts_with("Tracing."));
            self.devtools.keep_events(others);
            let traced: Vec<Event> = traced;
            trace.extend(traced.iter().flat_map(|event| event.params["value"].as_array()).flatten().cloned());
            if traced.iter().any(|event| event.method == "Tracing.tracingComplete") {
                return Ok(tasks(&trace));
            }
            thread::sleep(Duration::from_millis(20));
        }
    }

    fn happened(&mut self) -> Result<Vec<Happened>> {
        // Events that happened before this call have been received once it returns.
        self.evaluate("0")?;
        Ok(self.devtools.take_events().iter().filter_map(happened).collect())
    }
}

impl Drop for ChromiumTab {
    fn drop(&mut self) {
        // An error does not matter: a browser that has ended has closed its pages.
        let _ = self.devtools.call("Page.close", json!({}));
    }
}

fn happened(event: &Event) -> Option<Happened> {
    let params = &event.params;
    match event.method.as_str() {
        "Network.requestWillBeSent" => Some(Happened::Request(params["request"]["url"].as_str()?.to_owned())),
        "Runtime.exceptionThrown" => Some(Happened::Complaint(thrown(&params["exceptionDetails"]))),
        "Runtime.consoleAPICalled" if params["type"] == "error" || params["type"] == "assert" => {
            let words = params["args"].as_array()?.iter().map(|word| match &word["value"] {
                Value::String(text) => text.clone(),
                Value::Null => word["description"].as_str().unwrap_or_default().to_owned(),
                value => value.to_string(),
            });
            Some(Happened::Complaint(words.collect::<Vec<_>>().join(" ")))
        }
        "Log.entryAdded" if params["entry"]["level"] == "error" => {
            let entry = &params["entry"];
            let url = entry["url"].as_str().unwrap_or_default();
            Some(Happened::Complaint(format!("{} {url}", entry["text"].as_str()?)))
        }
        _ => None,
    }
}

/// The processor time in milliseconds of each task on the main threads of pages, in a trace.
fn tasks(trace: &[Value]) -> Vec<f64> {
    let thread = |event: &Value| (event["pid"].as_u64(), event["tid"].as_u64());
    let names = trace.iter().filter(|event| event["name"] == "thread_name");
    let main = names.filter(|event| event["args"]["name"] == "CrRendererMain").map(thread);
    let main: BTreeSet<_> = main.collect();
    let tasks = trace.iter().filter(|event| event["name"] == TASK && main.contains(&thread(event)));
    tasks.filter_map(|task| Some(task["tdur"].as_f64()? / 1000.0)).collect()
}

fn thrown(exception: &Value) -> String {
    let description = exception["exception"]["description"].as_str();
    description.or(exception["text"].as_str()).unwrap_or("an exception without a text").to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complaint(method: &str, params: Value) -> Option<String> {
        match happened(&Event { method: method.to_owned(), params })? {
            Happened::Complaint(words) => Some(words),
            Happened::Request(_) => None,
        }
    }

    #[test]
    fn errors_are_complaints_and_messages_are_not() {
        let words = json!([{ "type": "string", "value": "no light" }, { "type": "number", "value": 3 }]);
        let error = json!({ "type": "error", "args": words });
        assert_eq!(complaint("Runtime.consoleAPICalled", error).as_deref(), Some("no light 3"));
        let message = json!({ "type": "log", "args": words });
        assert_eq!(complaint("Runtime.consoleAPICalled", message), None);
        let missing = json!({ "entry": { "level": "error", "text": "404", "url": "http://127.0.0.1/a.js" } });
        assert_eq!(complaint("Log.entryAdded", missing).as_deref(), Some("404 http://127.0.0.1/a.js"));
        assert_eq!(complaint("Page.loadEventFired", json!({})), None);
    }

    #[test]
    fn tasks_of_main_threads_are_counted_by_processor_time() {
        let thread = |tid: u32, name: &str| json!({ "name": "thread_name", "pid": 1, "tid": tid, "args": { "name": name } });
        let task =
            |tid: u32, tdur: u32| json!({ "name": TASK, "pid": 1, "tid": tid, "dur": 90_000, "tdur": tdur });
        let trace = [task(2, 1500), task(3, 7000), thread(2, "CrRendererMain"), thread(3, "Compositor")];
        assert_eq!(tasks(&trace), [1.5]);
    }

    #[test]
    fn an_exception_is_told_with_its_description() {
        let exception = json!({ "text": "Uncaught", "exception": { "description": "Error: no canvas" } });
        let params = json!({ "exceptionDetails": exception });
        assert_eq!(complaint("Runtime.exceptionThrown", params).as_deref(), Some("Error: no canvas"));
        assert_eq!(thrown(&json!({ "text": "Uncaught 7" })), "Uncaught 7");
    }
}
