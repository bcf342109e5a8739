//! One page of WebKitGTK.

use std::cell::RefCell;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::PathBuf;
use std::rc::Rc;

use anyhow::{Context, Result, bail, ensure};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Value, json};

use super::driver::Driver;
use crate::actions;
use crate::page::WINDOW;
use crate::tab::{Clip, Happened, Tab};

/// A window of its own.
#[derive(Debug)]
pub(super) struct WebKitTab {
    driver: Rc<RefCell<Driver>>,
    /// Its name in the protocol.
    window: String,
    /// Its number in the browser's log.
    number: usize,
    log: PathBuf,
    /// How much of the log has been read, in bytes.
    read: u64,
}

impl WebKitTab {
    /// Opens an address in a new window.
    pub(super) fn visit(
        driver: Rc<RefCell<Driver>>,
        log: PathBuf,
        number: usize,
        address: &str,
    ) -> Result<Box<dyn Tab>> {
        let window = driver.borrow_mut().open()?;
        let mut tab = Self { driver, window, number, log, read: 0 };
        tab.resize(WINDOW.0, WINDOW.1, 1.0)?;
        tab.call("POST", "/url", &json!({ "url": address }))?;
        Ok(Box::new(tab))
    }

    fn call(&mut self, method: &str, path: &str, body: &Value) -> Result<Value> {
        self.driver.borrow_mut().call_in(&self.window, method, path, body)
    }

    fn act(&mut self, actions: &Value) -> Result<()> {
        self.call("POST", "/actions", &json!({ "actions": actions })).map(drop)
    }
}

impl Tab for WebKitTab {
    fn evaluate(&mut self, expression: &str) -> Result<Value> {
        // As JSON, because the driver refuses values such as typed arrays.
        let script = format!(
            "const done = arguments[arguments.length - 1];
             (async () => (\n{expression}\n))().then(
                 (value) => done(JSON.stringify({{ value }})),
                 (error) => done(JSON.stringify({{ error: String(error) }})),
             );"
        );
        let answer = self.call("POST", "/execute/async", &json!({ "script": script, "args": [] }))?;
        let answer = answer.as_str().context("WebKit has no answer")?;
        let mut answer: Value = serde_json::from_str(answer).context("WebKit's answer is no JSON")?;
        if let Some(error) = answer["error"].as_str() {
            bail!("the page threw {error}");
        }
        Ok(answer["value"].take())
    }

    fn resize(&mut self, width: u32, height: u32, density: f64) -> Result<()> {
        ensure!(density == 1.0, "WebDriver has no command for {density} pixels of the device a pixel");
        let size = json!({ "width": width, "height": height });
        let found = self.call("POST", "/window/rect", &size)?;
        ensure!(
            found["width"] == size["width"] && found["height"] == size["height"],
            "a window of {width} x {height} pixels was asked for: {found}"
        );
        Ok(())
    }

    fn drag(&mut self, along: &[(f64, f64)]) -> Result<()> {
        self.act(&actions::drag(along))
    }

    fn wheel(&mut self, at: (f64, f64), by: f64) -> Result<()> {
        self.act(&actions::wheel(at, by))
    }

    fn press(&mut self, key: &str, _code: u32) -> Result<()> {
        self.act(&actions::press(key)?)
    }

    fn type_text(&mut self, text: &str) -> Result<()> {
        self.act(&actions::type_text(text))
    }

    fn capture(&mut self, clip: Option<Clip>) -> Result<Vec<u8>> {
        ensure!(clip.is_none(), "WebKit's driver takes pictures of whole windows only");
        let data = self.call("GET", "/screenshot", &Value::Null)?;
        let data = data.as_str().context("WebKit took a screenshot without data")?;
        BASE64_STANDARD.decode(data).context("WebKit's screenshot is not base64")
    }

    fn set_offline(&mut self, _offline: bool) -> Result<()> {
        bail!("WebKit's driver has no command to disconnect a page")
    }

    fn force_colours(&mut self) -> Result<()> {
        bail!("WebKit has no forced colours")
    }

    fn happened(&mut self) -> Result<Vec<Happened>> {
        // What happened before this call is in the log once it returns.
        self.evaluate("0")?;
        let Ok(mut file) = File::open(&self.log) else { return Ok(Vec::new()) };
        file.seek(SeekFrom::Start(self.read))?;
        let mut lines = String::new();
        self.read += file.read_to_string(&mut lines)? as u64;
        Ok(lines.lines().filter_map(|line| happened(line, self.number)).collect())
    }
}

impl Drop for WebKitTab {
    fn drop(&mut self) {
        // An error does not matter: a browser that has ended has closed its pages.
        let _ = self.call("DELETE", "/window", &Value::Null);
    }
}

/// What a line of the log says of a window.
fn happened(line: &str, window: usize) -> Option<Happened> {
    let entry: Value = serde_json::from_str(line).ok()?;
    if entry["window"] != window {
        return None;
    }
    let text = |what: &str| entry[what].as_str().map(str::to_owned);
    text("request").map(Happened::Request).or_else(|| text("complaint").map(Happened::Complaint))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_belongs_to_its_window() {
        let line = r#"{"window": 2, "complaint": "no light"}"#;
        assert_eq!(happened(line, 2), Some(Happened::Complaint("no light".into())));
        assert_eq!(happened(line, 1), None);
        let line = r#"{"window": 2, "request": "a.js"}"#;
        assert_eq!(happened(line, 2), Some(Happened::Request("a.js".into())));
        assert_eq!(happened("{", 2), None);
    }
}
