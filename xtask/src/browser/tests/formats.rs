//! The number formats, of which f32 is the one to be compared with.

use anyhow::{Result, ensure};

use super::Visitor;

pub(super) fn agree(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    for format in ["f32", "fx32", "fx16"] {
        page.ask(&format!("luminaire.setFormat('{format}')"))?;
        let measured = page.ask("luminaire.measure(1)")?;
        ensure!(measured["format"] == format, "{format} was asked for: {measured}");
        page.ask("probe.settle()")?;
        page.ask(&format!("probe.keep('{format}')"))?;
    }
    for format in ["fx32", "fx16"] {
        let stated = page.number(&format!("luminaire.statedError('{format}')"))?;
        let found = page.number(&format!("probe.difference('f32', '{format}')"))?;
        ensure!(found <= stated, "{format} differs from f32 by {found} codes, the page states {stated}");
    }
    // By the visitor's own way, too.
    page.redraw(|page| page.ask("probe.enter('format', 'f32')").map(drop))?;
    let measured = page.ask("luminaire.measure(1)")?;
    ensure!(measured["format"] == "f32", "f32 was chosen: {measured}");
    page.must_be_content()
}
