//! A connection to one page or browser over a WebSocket: numbered calls with their results, and
//! events between them. The DevTools protocol and WebDriver BiDi have this in common.

use std::io;
use std::net::{Ipv4Addr, TcpStream};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, anyhow, bail};
use serde_json::{Value, json};
use tungstenite::{Message, WebSocket};

/// Upper bound of the time of any call to a page, even on a busy machine.
const PATIENCE: Duration = Duration::from_secs(300);

#[derive(Debug)]
pub(super) struct Socket {
    /// The browser's name, for messages.
    browser: &'static str,
    socket: WebSocket<TcpStream>,
    calls: u64,
    events: Vec<Event>,
}

/// An event of the browser.
#[derive(Debug)]
pub(super) struct Event {
    pub(super) method: String,
    pub(super) params: Value,
}

impl Socket {
    /// Connects to a path such as `/devtools/page/…` of a browser on this machine.
    pub(super) fn connect(browser: &'static str, port: u16, path: &str) -> Result<Self> {
        let stream = TcpStream::connect((Ipv4Addr::LOCALHOST, port))
            .with_context(|| format!("cannot reach {browser} on port {port}"))?;
        stream.set_read_timeout(Some(PATIENCE))?;
        stream.set_nodelay(true)?;
        let (socket, _) = tungstenite::client(format!("ws://127.0.0.1:{port}{path}"), stream)
            .map_err(|error| anyhow!("cannot talk to {browser}: {error}"))?;
        Ok(Self { browser, socket, calls: 0, events: Vec::new() })
    }

    /// Calls a method of the protocol and waits for its result.
    pub(super) fn call(&mut self, method: &str, params: Value) -> Result<Value> {
        let browser = self.browser;
        self.calls += 1;
        let call = json!({ "id": self.calls, "method": method, "params": params });
        self.socket.send(Message::text(call.to_string())).with_context(|| format!("cannot send {method}"))?;
        let deadline = Instant::now() + PATIENCE;
        while Instant::now() < deadline {
            let text = match self.socket.read() {
                Ok(Message::Text(text)) => text,
                // Messages other than text belong to the WebSocket protocol itself.
                Ok(_) => continue,
                Err(tungstenite::Error::Io(error)) if is_timeout(&error) => break,
                Err(error) => bail!("{browser} broke off at {method}: {error}"),
            };
            let mut answer: Value =
                serde_json::from_str(&text).with_context(|| format!("{browser} does not speak JSON"))?;
            if answer["id"] != self.calls {
                self.events.extend(Event::from(answer));
            } else if let Some(error) = answer.get("error") {
                let message = answer["message"].as_str().unwrap_or_default();
                bail!("{browser} refuses {method}: {error} {message}");
            } else {
                return Ok(answer["result"].take());
            }
        }
        bail!("{browser} has not answered {method} within {PATIENCE:?}");
    }

    /// Returns the events since the last call.
    pub(super) fn take_events(&mut self) -> Vec<Event> {
        std::mem::take(&mut self.events)
    }

    /// Keeps events for a later call of [`take_events`](Self::take_events).
    pub(super) fn keep_events(&mut self, mut events: Vec<Event>) {
        events.append(&mut self.events);
        self.events = events;
    }
}

/// Whether a read has timed out, which systems report by two different kinds of error.
fn is_timeout(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut)
}

impl Event {
    fn from(mut message: Value) -> Option<Self> {
        let method = message["method"].as_str()?.to_owned();
        Some(Self { method, params: message["params"].take() })
    }
}
