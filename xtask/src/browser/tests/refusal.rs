//! Values that a light cannot take.

use anyhow::{Result, ensure};

use super::Visitor;

pub(super) fn is_told_and_harmless(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let good = page.number("probe.value('light-0-field-number')")?;
    ensure!(page.text("probe.text('light-0-error')")?.is_empty(), "a light that is fine has an error");
    page.ask("probe.keep('before')")?;
    // An empty field is what a number input makes of every text that is no number.
    for value in ["400", "0", "-10", ""] {
        page.ask(&format!("probe.enter('light-0-field-number', '{value}')"))?;
        page.ask("probe.settle()")?;
        let message = page.text("probe.text('light-0-error')")?;
        ensure!(
            message.to_lowercase().contains("field angle"),
            "a field angle of {value:?} is answered with {message:?}"
        );
        ensure!(page.holds("probe.visible('light-0-error')")?, "the message about {value:?} cannot be seen");
        page.ask("probe.keep('after')")?;
        let difference = page.number("probe.difference('before', 'after')")?;
        ensure!(difference == 0.0, "a field angle of {value:?} changed the picture by {difference}");
    }
    page.ask(&format!("probe.enter('light-0-field-number', '{good}')"))?;
    page.ask("probe.settle()")?;
    let message = page.text("probe.text('light-0-error')")?;
    ensure!(message.is_empty(), "a field angle of {good} is answered with {message:?}");
    page.must_be_content()
}
