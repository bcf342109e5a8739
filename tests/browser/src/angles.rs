//! The two angles of a beam, and its edge.

use anyhow::{Result, ensure};

use crate::Visitor;

/// However the angles are coupled, a field angle that becomes narrower than the beam angle must
/// move the beam angle.
pub(crate) fn field_leads_beam(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let (least, _) = page.range("light-0-field")?;
    let beam = page.value("light-0-beam")?;
    page.change("the field slider", |page| page.enter("light-0-field", f64::midpoint(least, beam)))?;
    let (field, follower) = (page.value("light-0-field")?, page.value("light-0-beam")?);
    ensure!(field < beam, "the field slider went to {field}, not below the beam's {beam}");
    ensure!(follower <= field, "the beam angle {follower} did not follow the field angle {field}");
    let number = page.value("light-0-field-number")?;
    ensure!((number - field).abs() < 0.1, "the number says {number}, the slider {field}");
    page.must_be_content()
}

/// A beam angle that becomes wider than the field angle must move the field angle.
pub(crate) fn beam_leads_field(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let (_, greatest) = page.range("light-0-beam")?;
    let field = page.value("light-0-field")?;
    page.change("the beam slider", |page| page.enter("light-0-beam", f64::midpoint(greatest, field)))?;
    let (beam, follower) = (page.value("light-0-beam")?, page.value("light-0-field")?);
    ensure!(beam > field, "the beam slider went to {beam}, not above the field's {field}");
    ensure!(follower >= beam, "the field angle {follower} did not follow the beam angle {beam}");
    let number = page.value("light-0-beam-number")?;
    ensure!((number - beam).abs() < 0.1, "the number says {number}, the slider {beam}");
    page.must_be_content()
}

pub(crate) fn edge_changes_picture(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    page.enter("light-0-edge", "soft")?;
    page.change("the hard edge", |page| page.enter("light-0-edge", "hard"))?;
    page.must_be_content()
}
