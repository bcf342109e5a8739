//! The fixtures that a light can be, and the settings of a light.

use anyhow::{Context, Result, ensure};

use crate::Visitor;

/// Number of fixtures that are tested, evenly spread over the list.
const SAMPLE: usize = 8;

pub(crate) fn can_be_chosen(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let options = page.ask("probe.options('light-fixtures')")?;
    let options = options.as_array().context("the list of fixtures is no list")?;
    ensure!(!options.is_empty(), "the list of fixtures is empty");
    for option in options.iter().step_by(options.len().div_ceil(SAMPLE)) {
        page.enter("light-fixture", option.as_str().context("a fixture has no name")?)?;
        let message = page.message("light-error")?;
        ensure!(message.is_empty(), "the fixture {option} is answered with {message:?}");
        ensure!(page.shows("light-published")?, "the fixture {option} is not chosen");
        ensure!(page.lit_share()? > 0.0, "with the fixture {option} the picture is black");
        page.must_be_content().with_context(|| format!("after choosing the fixture {option}"))?;
    }
    Ok(())
}

pub(crate) fn intensity_is_seen(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let (least, _) = page.range("light-intensity")?;
    page.change("the intensity", |page| page.enter("light-intensity", least))?;
    page.must_be_content()
}

pub(crate) fn colour_is_seen(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    page.change("the colour", |page| page.enter("light-color", "#ff0000"))?;
    page.must_be_content()
}
