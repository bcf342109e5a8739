//! The two angles of a beam, and its edge.

use anyhow::{Result, ensure};

use crate::Visitor;

/// However the angles are coupled, a field angle that becomes narrower than the beam angle must
/// move the beam angle.
pub(crate) fn field_leads_beam(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let (least, _) = page.range("light-field")?;
    let beam = page.value("light-beam")?;
    page.change("the field slider", |page| page.enter("light-field", f64::midpoint(least, beam)))?;
    let (field, follower) = (page.value("light-field")?, page.value("light-beam")?);
    ensure!(field < beam, "the field slider went to {field}, not below the beam's {beam}");
    ensure!(follower <= field, "the beam angle {follower} did not follow the field angle {field}");
    let number = page.value("light-field-number")?.log10();
    ensure!((number - field).abs() < 0.01, "the logarithm of the number is {number}, the slider's {field}");
    page.must_be_content()
}

/// A beam angle that becomes wider than the field angle must move the field angle.
pub(crate) fn beam_leads_field(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let (_, greatest) = page.range("light-beam")?;
    let field = page.value("light-field")?;
    page.change("the beam slider", |page| page.enter("light-beam", f64::midpoint(greatest, field)))?;
    let (beam, follower) = (page.value("light-beam")?, page.value("light-field")?);
    ensure!(beam > field, "the beam slider went to {beam}, not above the field's {field}");
    ensure!(follower >= beam, "the field angle {follower} did not follow the beam angle {beam}");
    let number = page.value("light-beam-number")?.log10();
    ensure!((number - beam).abs() < 0.01, "the logarithm of the number is {number}, the slider's {beam}");
    page.must_be_content()
}

pub(crate) fn edge_changes_picture(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    page.enter("light-edge", "soft")?;
    page.change("the hard edge", |page| page.enter("light-edge", "hard"))?;
    page.must_be_content()
}
