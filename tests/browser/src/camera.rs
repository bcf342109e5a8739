//! The camera, moved by hand.

use anyhow::Result;

use crate::Visitor;

/// The arrow keys, with the codes that keyboards give them.
const ARROWS: [(&str, u32); 4] = [("ArrowLeft", 37), ("ArrowUp", 38), ("ArrowRight", 39), ("ArrowDown", 40)];

pub(crate) fn is_dragged(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let middle = page.middle("view")?;
    page.change("dragging", |page| page.drag(middle, (90.0, 30.0)))?;
    page.must_be_content()
}

pub(crate) fn is_wheeled(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let middle = page.middle("view")?;
    page.change("the wheel", |page| page.wheel(middle, 120.0))?;
    page.must_be_content()
}

pub(crate) fn is_moved_by_keys(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    page.ask("document.getElementById('view').focus()")?;
    for (key, code) in ARROWS {
        page.change(key, |page| page.press(key, code))?;
    }
    page.must_be_content()
}
