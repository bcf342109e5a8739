//! The session of WebKitWebDriver.

use std::time::Duration;

use anyhow::{Context, Result, bail};
use serde_json::{Value, json};
use ureq::Agent;
use ureq::http::Request;

/// Upper bound of the time of any call to a page, even on a busy machine.
const PATIENCE: Duration = Duration::from_secs(300);

/// A session, whose windows are the pages.
#[derive(Debug)]
pub(super) struct Driver {
    agent: Agent,
    /// The address of the session.
    session: String,
    version: String,
    /// The window that the session begins with, and that stays blank.
    first: String,
    /// The window that calls are for.
    window: String,
}

impl Driver {
    /// Connects to the driver and starts the browser. Returns `None` while the driver does not
    /// listen.
    pub(super) fn connect(port: u16, capabilities: &Value) -> Result<Option<Self>> {
        let config = Agent::config_builder()
            .timeout_global(Some(2 * PATIENCE))
            .http_status_as_error(false)
            .proxy(None)
            .build();
        let agent = Agent::new_with_config(config);
        let address = format!("http://127.0.0.1:{port}");
        if agent.get(format!("{address}/status")).call().is_err() {
            return Ok(None);
        }
        let [version, first, window] = [const { String::new() }; 3];
        let mut driver = Self { agent, session: address, version, first, window };
        let opened = json!({ "capabilities": { "alwaysMatch": capabilities } });
        let opened = driver.call("POST", "/session", &opened)?;
        let id = opened["sessionId"].as_str().context("WebKit opened a session without a name")?;
        driver.session = format!("{}/session/{id}", driver.session);
        let version = opened["capabilities"]["browserVersion"].as_str();
        driver.version = version.unwrap_or_default().to_owned();
        let limits =
            json!({ "script": PATIENCE.as_millis() as u64, "pageLoad": PATIENCE.as_millis() as u64 });
        driver.call("POST", "/timeouts", &limits)?;
        let first = driver.call("GET", "/window", &Value::Null)?;
        driver.first = first.as_str().context("WebKit has a window without a name")?.to_owned();
        Ok(Some(driver))
    }

    pub(super) fn version(&self) -> &str {
        &self.version
    }

    /// Opens a window, and returns its name.
    pub(super) fn open(&mut self) -> Result<String> {
        // A window is opened from another one, and all but the first may have been closed.
        let first = self.first.clone();
        let opened = self.call_in(&first, "POST", "/window/new", &json!({ "type": "window" }))?;
        Ok(opened["handle"].as_str().context("WebKit opened a window without a name")?.to_owned())
    }

    /// Calls a command for a window.
    pub(super) fn call_in(&mut self, window: &str, method: &str, path: &str, body: &Value) -> Result<Value> {
        if self.window != window {
            self.call("POST", "/window", &json!({ "handle": window }))?;
            window.clone_into(&mut self.window);
        }
        self.call(method, path, body)
    }

    /// Whether the session goes on. The driver ends it when a page's process has crashed.
    pub(super) fn has_session(&mut self) -> bool {
        self.call("GET", "/timeouts", &Value::Null).is_ok()
    }

    /// Ends the session, and with it the browser.
    pub(super) fn quit(&mut self) -> Result<()> {
        self.call("DELETE", "", &Value::Null).map(drop)
    }

    fn call(&mut self, method: &str, path: &str, body: &Value) -> Result<Value> {
        let request = Request::builder().method(method).uri(format!("{}{path}", self.session));
        let body = if body.is_null() { String::new() } else { body.to_string() };
        let mut response =
            self.agent.run(request.body(body)?).with_context(|| format!("WebKit broke off at {path}"))?;
        let answer = response.body_mut().with_config().limit(u64::MAX).read_to_string()?;
        let mut answer: Value = serde_json::from_str(&answer).context("WebKit does not speak JSON")?;
        if let Some(error) = answer["value"]["error"].as_str() {
            bail!("WebKit refuses {path}: {error} {}", answer["value"]["message"]);
        }
        Ok(answer["value"].take())
    }
}
