//! The first picture.

use anyhow::{Result, ensure};

use super::Visitor;

pub(super) fn becomes_ready(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    ensure!(page.holds("window.crossOriginIsolated")?, "the page is not crossOriginIsolated");
    ensure!(!page.holds("probe.visible('failure')")?, "#failure is visible though nothing failed");
    page.must_be_content()
}

pub(super) fn is_lit(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let survey = page.ask("probe.survey()")?;
    let (lit, colours) = (survey["lit"].as_f64(), survey["colours"].as_u64());
    ensure!(survey["pixels"] == 960 * 540, "the picture has {} pixels", survey["pixels"]);
    ensure!(lit > Some(0.05), "a share of only {lit:?} of the pixels is lit");
    ensure!(colours > Some(16), "the picture has only {colours:?} colours");
    page.must_be_content()
}

pub(super) fn has_the_asked_size(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("?width=320&height=180")?;
    let measured = page.ask("luminaire.measure(1)")?;
    ensure!(measured["width"] == 320 && measured["height"] == 180, "320x180 was asked for: {measured}");
    let pixels = page.number("probe.survey().pixels")?;
    ensure!(pixels == 320.0 * 180.0, "the picture has {pixels} pixels");
    page.must_be_content()
}
