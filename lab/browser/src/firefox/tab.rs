//! One page of Firefox.

use std::cell::RefCell;
use std::rc::Rc;

use anyhow::{Context, Result, bail};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Map, Value, json};

use crate::actions;
use crate::page::{PROBE, WINDOW};
use crate::socket::{Event, Socket};
use crate::tab::{Clip, Happened, Tab};

/// A tab in a container of its own, so that it shares no storage with others.
#[derive(Debug)]
pub(super) struct FirefoxTab {
    session: Rc<RefCell<Socket>>,
    /// Its name in the protocol.
    context: String,
    container: String,
}

impl FirefoxTab {
    /// Opens an address. `script` runs before the page's own scripts.
    pub(super) fn visit(session: Rc<RefCell<Socket>>, address: &str, script: &str) -> Result<Box<dyn Tab>> {
        let call = |method, params| session.borrow_mut().call(method, params);
        let name = |answer: Value, what| {
            let name = answer[what].as_str().map(str::to_owned);
            name.with_context(|| format!("Firefox opened a page without its {what}"))
        };
        let container = name(call("browser.createUserContext", json!({}))?, "userContext")?;
        let tab = json!({ "type": "tab", "userContext": container });
        let context = name(call("browsingContext.create", tab)?, "context")?;
        let mut tab = Self { session, context, container };
        tab.resize(WINDOW.0, WINDOW.1, 1.0)?;
        let function = format!("() => {{\n{PROBE};\n{script};\n}}");
        tab.session.borrow_mut().call(
            "script.addPreloadScript",
            json!({ "contexts": [tab.context], "functionDeclaration": function }),
        )?;
        tab.call("browsingContext.navigate", json!({ "url": address, "wait": "interactive" }))?;
        Ok(Box::new(tab))
    }

    /// Calls a method that has this page as its parameter `context`.
    fn call(&mut self, method: &str, mut params: Value) -> Result<Value> {
        params["context"] = json!(self.context);
        self.session.borrow_mut().call(method, params)
    }

    fn act(&mut self, actions: Value) -> Result<()> {
        self.call("input.performActions", json!({ "actions": actions })).map(drop)
    }
}

impl Tab for FirefoxTab {
    fn evaluate(&mut self, expression: &str) -> Result<Value> {
        let call = json!({
            "expression": expression, "awaitPromise": true, "userActivation": true,
            "target": { "context": self.context },
        });
        let answer = self.session.borrow_mut().call("script.evaluate", call)?;
        if answer["type"] == "exception" {
            bail!("the page threw {}", answer["exceptionDetails"]["text"]);
        }
        Ok(plain(&answer["result"]))
    }

    fn resize(&mut self, width: u32, height: u32, density: f64) -> Result<()> {
        let viewport = json!({ "width": width, "height": height });
        let size = json!({ "viewport": viewport, "devicePixelRatio": density });
        self.call("browsingContext.setViewport", size).map(drop)
    }

    fn drag(&mut self, along: &[(f64, f64)]) -> Result<()> {
        self.act(actions::drag(along))
    }

    fn wheel(&mut self, at: (f64, f64), by: f64) -> Result<()> {
        self.act(actions::wheel(at, by))
    }

    fn press(&mut self, key: &str, _code: u32) -> Result<()> {
        self.act(actions::press(key)?)
    }

    fn type_text(&mut self, text: &str) -> Result<()> {
        self.act(actions::type_text(text))
    }

    fn capture(&mut self, clip: Option<Clip>) -> Result<Vec<u8>> {
        let mut what = json!({});
        if let Some(Clip { x, y, width, height }) = clip {
            what["origin"] = json!("document");
            what["clip"] = json!({ "type": "box", "x": x, "y": y, "width": width, "height": height });
        }
        let answer = self.call("browsingContext.captureScreenshot", what)?;
        let data = answer["data"].as_str().context("Firefox took a screenshot without data")?;
        BASE64_STANDARD.decode(data).context("Firefox's screenshot is not base64")
    }

    fn set_offline(&mut self, offline: bool) -> Result<()> {
        let conditions = if offline { json!({ "type": "offline" }) } else { Value::Null };
        let call = json!({ "networkConditions": conditions, "contexts": [self.context] });
        self.session.borrow_mut().call("emulation.setNetworkConditions", call).map(drop)
    }

    fn force_colours(&mut self) -> Result<()> {
        bail!("Firefox has no method to force colours")
    }

    fn happened(&mut self) -> Result<Vec<Happened>> {
        // Events that happened before this call have been received once it returns.
        self.evaluate("0")?;
        let mut session = self.session.borrow_mut();
        let (own, others) =
            session.take_events().into_iter().partition(|event| belongs_to(event, &self.context));
        session.keep_events(others);
        let own: Vec<Event> = own;
        Ok(own.iter().filter_map(happened).collect())
    }
}

impl Drop for FirefoxTab {
    fn drop(&mut self) {
        // An error does not matter: a browser that has ended has closed its pages.
        let _ = self.happened();
        let removed = json!({ "userContext": self.container });
        let _ = self.session.borrow_mut().call("browser.removeUserContext", removed);
    }
}

fn belongs_to(event: &Event, context: &str) -> bool {
    [&event.params["context"], &event.params["source"]["context"]].iter().any(|name| *name == context)
}

fn happened(event: &Event) -> Option<Happened> {
    let params = &event.params;
    let address = || params["request"]["url"].as_str();
    match event.method.as_str() {
        "network.beforeRequestSent" => Some(Happened::Request(address()?.to_owned())),
        "network.responseCompleted" => {
            let status = params["response"]["status"].as_u64().filter(|status| *status >= 400)?;
            Some(Happened::Complaint(format!("{status} {}", address()?)))
        }
        "network.fetchError" => {
            Some(Happened::Complaint(format!("{} {}", params["errorText"].as_str()?, address()?)))
        }
        "log.entryAdded" if params["level"] == "error" => {
            Some(Happened::Complaint(params["text"].as_str()?.to_owned()))
        }
        _ => None,
    }
}

/// A value of the protocol as the JSON that it stands for. What JSON cannot express becomes `null`,
/// as in `JSON.stringify`.
fn plain(value: &Value) -> Value {
    let content = &value["value"];
    match value["type"].as_str() {
        Some("string" | "boolean") => content.clone(),
        // NaN and infinities are strings here.
        Some("number") if content == "-0" => json!(0),
        Some("number") if content.is_number() => content.clone(),
        Some("array") => content.as_array().into_iter().flatten().map(plain).collect(),
        Some("object") => {
            let entries = content.as_array().into_iter().flatten();
            let entry = |entry: &Value| Some((entry[0].as_str()?.to_owned(), plain(&entry[1])));
            entries.filter_map(entry).collect::<Map<_, _>>().into()
        }
        _ => Value::Null,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_those_of_json() {
        let number = json!({ "type": "number", "value": 1.5 });
        let array = json!({ "type": "array", "value": [number, { "type": "number", "value": "NaN" }] });
        let object = json!({ "type": "object", "value": [["a", array], ["b", { "type": "undefined" }]] });
        assert_eq!(plain(&object), json!({ "a": [1.5, null], "b": null }));
        assert_eq!(plain(&json!({ "type": "number", "value": "-0" })), json!(0));
        assert_eq!(plain(&json!({ "type": "string", "value": "lit" })), json!("lit"));
    }

    #[test]
    fn errors_are_complaints_and_messages_are_not() {
        let told = |method: &str, params: Value| happened(&Event { method: method.to_owned(), params });
        let entry = |level: &str| json!({ "level": level, "text": "no light" });
        assert_eq!(told("log.entryAdded", entry("error")), Some(Happened::Complaint("no light".into())));
        assert_eq!(told("log.entryAdded", entry("info")), None);
        let answered =
            |status: u16| json!({ "request": { "url": "a.js" }, "response": { "status": status } });
        let missing = Some(Happened::Complaint("404 a.js".into()));
        assert_eq!(told("network.responseCompleted", answered(404)), missing);
        assert_eq!(told("network.responseCompleted", answered(200)), None);
        assert_eq!(told("network.beforeRequestSent", answered(0)), Some(Happened::Request("a.js".into())));
    }
}
