//! What a light is, and how it is set.

use anyhow::{Context, Result, ensure};

use super::Visitor;

/// So many of a long list are tried, evenly spread over it.
const SAMPLE: usize = 8;

pub(super) fn can_be_chosen(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let options = page.ask("probe.options('light-0-fixture')")?;
    let options = options.as_array().context("the list of fixtures is no list")?;
    ensure!(!options.is_empty(), "the list of fixtures is empty");
    for option in options.iter().step_by(options.len().div_ceil(SAMPLE)) {
        page.ask(&format!("probe.enter('light-0-fixture', {option})"))?;
        page.ask("probe.settle()")?;
        let message = page.text("probe.text('light-0-error')")?;
        ensure!(message.is_empty(), "the fixture {option} is answered with {message:?}");
        page.must_be_content().with_context(|| format!("after choosing the fixture {option}"))?;
    }
    ensure!(page.number("probe.survey().lit")? > 0.0, "with the last fixture the picture is black");
    Ok(())
}

pub(super) fn light_can_be_set(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    for (id, value) in [("light-0-intensity", "MIN"), ("light-1-color", "#ff0000")] {
        page.ask("probe.keep('before')")?;
        let value = if value == "MIN" {
            format!("document.getElementById('{id}').min")
        } else {
            format!("'{value}'")
        };
        page.ask(&format!("probe.change('{id}', {value})"))?;
        page.ask("probe.keep('after')")?;
        let difference = page.number("probe.difference('before', 'after')")?;
        ensure!(difference > 0.0, "setting #{id} leaves the picture as it was");
    }
    page.must_be_content()
}
