//! Values that a light cannot take.

use anyhow::{Result, ensure};

use super::Visitor;

const FIELD: &str = "light-0-field-number";
const ERROR: &str = "light-0-error";

pub(super) fn is_told_and_harmless(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let good = page.value(FIELD)?;
    ensure!(page.message(ERROR)?.is_empty(), "a light that is fine has an error");
    page.keep("before")?;
    // An empty text is what a number input makes of everything that is no number.
    for value in ["400", "0", "-10", ""] {
        page.enter(FIELD, value)?;
        let message = page.message(ERROR)?;
        let named = message.to_lowercase().contains("field angle");
        ensure!(named, "a field angle of {value:?} is answered with {message:?}");
        ensure!(page.shows(ERROR)?, "the message about {value:?} cannot be seen");
        page.keep("after")?;
        let difference = page.difference("before", "after")?;
        ensure!(difference == 0.0, "a field angle of {value:?} changed the picture by {difference}");
    }
    page.enter(FIELD, good)?;
    let message = page.message(ERROR)?;
    ensure!(message.is_empty(), "a field angle of {good} is answered with {message:?}");
    page.must_be_content()
}
