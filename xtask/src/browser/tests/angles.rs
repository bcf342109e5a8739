//! The two angles of a beam, and its edge.

use anyhow::{Result, ensure};

use super::Visitor;

/// Whatever way the angles are coupled, a field narrower than the beam must take the beam along.
pub(super) fn field_leads_beam(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    page.ask("probe.keep('before')")?;
    let beam = page.number("probe.value('light-0-beam')")?;
    page.ask("probe.change('light-0-field', (Number(document.getElementById('light-0-field').min) + probe.value('light-0-beam')) / 2)")?;
    page.ask("probe.keep('after')")?;
    ensure!(page.number("probe.difference('before', 'after')")? > 0.0, "the picture did not change");
    let (field, follower) =
        (page.number("probe.value('light-0-field')")?, page.number("probe.value('light-0-beam')")?);
    ensure!(field < beam, "the field slider went to {field}, not below the beam's {beam}");
    ensure!(follower <= field, "the beam angle {follower} did not follow the field angle {field}");
    let number = page.number("probe.value('light-0-field-number')")?;
    ensure!((number - field).abs() < 0.1, "the number says {number}, the slider {field}");
    page.must_be_content()
}

pub(super) fn beam_leads_field(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    page.ask("probe.keep('before')")?;
    let field = page.number("probe.value('light-0-field')")?;
    page.ask("probe.change('light-0-beam', (Number(document.getElementById('light-0-beam').max) + probe.value('light-0-field')) / 2)")?;
    page.ask("probe.keep('after')")?;
    ensure!(page.number("probe.difference('before', 'after')")? > 0.0, "the picture did not change");
    let (beam, follower) =
        (page.number("probe.value('light-0-beam')")?, page.number("probe.value('light-0-field')")?);
    ensure!(beam > field, "the beam slider went to {beam}, not above the field's {field}");
    ensure!(follower >= beam, "the field angle {follower} did not follow the beam angle {beam}");
    page.must_be_content()
}

pub(super) fn edge_changes_picture(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    for edge in ["soft", "hard"] {
        page.ask(&format!("probe.enter('light-0-edge', '{edge}')"))?;
        page.ask("probe.settle()")?;
        page.ask(&format!("probe.keep('{edge}')"))?;
    }
    ensure!(page.number("probe.difference('soft', 'hard')")? > 0.0, "soft and hard look the same");
    page.must_be_content()
}
