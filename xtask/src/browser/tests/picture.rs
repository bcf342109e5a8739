//! The first picture.

use anyhow::{Result, ensure};

use super::Visitor;

pub(super) fn becomes_ready(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    ensure!(page.holds("window.crossOriginIsolated")?, "the page is not crossOriginIsolated");
    ensure!(!page.shows("failure")?, "#failure is visible though nothing failed");
    page.must_be_content()
}

pub(super) fn is_lit(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let (lit, colours) = (page.lit_share()?, page.number("probe.survey().colours")?);
    ensure!(lit > 0.05, "a share of only {lit} of the pixels is lit");
    ensure!(colours > 16.0, "the picture has only {colours} colours");
    page.must_be_content()
}

pub(super) fn has_the_asked_size(visitor: &mut Visitor) -> Result<()> {
    for (query, width, height) in [("", 960, 540), ("?width=320&height=180", 320, 180)] {
        let mut page = visitor.ready_at(query)?;
        let measured = page.ask("luminaire.measure(1)")?;
        let right = measured["width"] == width && measured["height"] == height;
        ensure!(right, "{width}x{height} was asked for: {measured}");
        let pixels = page.number("probe.survey().pixels")?;
        ensure!(pixels == f64::from(width * height), "{width}x{height} was asked for: {pixels} pixels");
        page.must_be_content()?;
    }
    Ok(())
}
