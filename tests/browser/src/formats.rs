//! The number formats, which are compared with f32.

use anyhow::{Result, ensure};

use crate::Visitor;
use browser::Page;

/// Upper bound, in displayed codes, of a format's difference from f32, whatever the page states.
/// Beyond it, the picture would not show the same scene.
const TOLERABLE: f64 = 64.0;

pub(crate) fn agree(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    // At the edge of a shadow a pixel is in the light in one format and in the dark in another.
    page.ask("document.getElementById('effect-shadow').click()")?;
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
    page.settle()?;
    let taken = page.text("luminaire.format")?;
    ensure!(taken == format && page.lit_share()? > 0.0, "{format} was asked for: {taken}");
    Ok(())
}
