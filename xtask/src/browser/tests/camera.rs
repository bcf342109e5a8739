//! The camera, moved by hand.

use anyhow::{Result, ensure};

use super::Visitor;
use crate::browser::Page;

pub(super) fn moves(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let middle = page.ask("probe.middle('view')")?;
    let middle = (middle["x"].as_f64().unwrap_or_default(), middle["y"].as_f64().unwrap_or_default());
    changes(&mut page, "dragging", |page| page.drag(middle, (90.0, 30.0)))?;
    changes(&mut page, "the wheel", |page| page.wheel(middle, 120.0))?;
    page.ask("document.getElementById('view').focus()")?;
    for (key, code) in [("ArrowLeft", 37), ("ArrowUp", 38), ("ArrowRight", 39), ("ArrowDown", 40)] {
        changes(&mut page, key, |page| page.press(key, code))?;
    }
    page.must_be_content()
}

fn changes(page: &mut Page, what: &str, touch: impl FnOnce(&mut Page) -> Result<()>) -> Result<()> {
    page.ask("probe.keep('before')")?;
    page.redraw(touch).map_err(|error| error.context(format!("{what} has no effect")))?;
    page.ask("probe.keep('after')")?;
    ensure!(page.number("probe.difference('before', 'after')")? > 0.0, "{what} leaves the picture as it was");
    Ok(())
}
