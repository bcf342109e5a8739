//! The show needs no more memory the longer it plays.

use std::thread;
use std::time::Duration;

use anyhow::{Context, Result, ensure};
use serde_json::{Value, json};

use crate::Visitor;
use browser::Page;

/// How long the show plays.
const SHOW: Duration = Duration::from_secs(300);

/// How long it plays before it is measured, until the browser has compiled its scripts.
const WARM_UP: Duration = Duration::from_secs(30);

/// Upper bounds of the growth: JavaScript's memory in bytes, and nodes of the document. A machine that
/// draws ten pictures a second draws 3,000 of them.
const GROWTH: f64 = 200_000.0;
const NODES: f64 = 100.0;

#[derive(Debug)]
struct Use {
    nodes: f64,
    listeners: f64,
    heap: f64,
    modules: f64,
    pictures: f64,
}

pub(crate) fn stays_for_five_minutes(visitor: &mut Visitor) -> Result<()> {
    let query = "?width=320&height=180#stage?scene=show";
    let mut page = visitor.browser.open(&format!("{}{query}", visitor.address), "")?;
    page.ready()?;
    page.devtools("Performance.enable", json!({}))?;
    page.ask("document.getElementById('price').scrollIntoView()")?;
    thread::sleep(WARM_UP);
    let before = measure(&mut page)?;
    thread::sleep(SHOW);
    let after = measure(&mut page)?;
    ensure!(after.pictures > before.pictures + 300.0, "the show does not play: {before:?}, {after:?}");
    let is_same = after.nodes - before.nodes < NODES
        && before.listeners == after.listeners
        && before.modules == after.modules
        && after.heap - before.heap < GROWTH;
    ensure!(is_same, "memory grows: {before:?}, {after:?}");
    page.must_be_content()
}

/// What is in use after all garbage is collected.
fn measure(page: &mut Page) -> Result<Use> {
    for _ in 0..3 {
        page.devtools("HeapProfiler.collectGarbage", json!({}))?;
    }
    let metrics = page.devtools("Performance.getMetrics", json!({}))?;
    let metric = |name: &str| {
        let mut all = metrics["metrics"].as_array().into_iter().flatten();
        let found = all.find(|metric| metric["name"] == name).map(|metric| &metric["value"]);
        found.and_then(Value::as_f64).with_context(|| format!("Chromium does not tell {name}"))
    };
    Ok(Use {
        nodes: metric("Nodes")?,
        listeners: metric("JSEventListeners")?,
        heap: metric("JSHeapUsedSize")?,
        modules: page.number("luminaire.memory()")?,
        pictures: page.number("luminaire.drawn")?,
    })
}
