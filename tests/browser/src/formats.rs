//! The number formats, of which f32 is the one to be compared with.

use anyhow::{Result, ensure};

use crate::Visitor;
use tools::browser::Page;

/// A format that differs more than this would be no picture of the same scene, whatever the page
/// states.
const TOLERABLE: f64 = 64.0;

pub(crate) fn agree(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    for format in ["f32", "fx32", "fx16"] {
        page.ask(&format!("luminaire.setFormat('{format}')"))?;
        must_light_in(&mut page, format)?;
        page.keep(format)?;
    }
    for format in ["fx32", "fx16"] {
        let stated = page.number(&format!("luminaire.statedError('{format}')"))?;
        let found = page.difference("f32", format)?;
        ensure!(stated <= TOLERABLE, "{format} is said to differ from f32 by {stated} codes");
        ensure!(found <= stated, "{format} differs from f32 by {found} codes, the page states {stated}");
    }
    page.must_be_content()
}

pub(crate) fn can_be_chosen(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    for format in ["fx16", "fx32", "f32"] {
        page.enter("format", format)?;
        must_light_in(&mut page, format)?;
    }
    page.must_be_content()
}

fn must_light_in(page: &mut Page, format: &str) -> Result<()> {
    let measured = page.ask("luminaire.measure(1)")?;
    ensure!(measured["format"] == format, "{format} was asked for: {measured}");
    page.settle()
}
