//! Values that a light cannot take.

use anyhow::{Result, ensure};

use super::Visitor;
use crate::browser::Page;

const FIELD: &str = "light-0-field-number";
const ERROR: &str = "light-0-error";

pub(super) fn is_told_and_harmless(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let good = page.value(FIELD)?;
    ensure!(page.message(ERROR)?.is_empty(), "a light that is fine has an error");
    // An empty text is what a number input makes of everything that is no number.
    must_refuse(&mut page, FIELD, "field angle", &["400", "0", "-10", ""])?;
    page.enter(FIELD, good)?;
    let message = page.message(ERROR)?;
    ensure!(message.is_empty(), "a field angle of {good} is answered with {message:?}");
    page.must_be_content()
}

pub(super) fn are_all_told(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    must_refuse(&mut page, "light-0-intensity", "intensity", &["-1", "1e40", ""])?;
    page.enter("light-0-fixture", "ARRI L7-C")?;
    must_refuse(&mut page, "light-0-zoom-number", "zoom", &["5", "5000", "-15", ""])?;
    // A picker of colours holds nothing else; what it was before it was one can.
    page.ask("document.getElementById('light-0-color').type = 'text'")?;
    must_refuse(&mut page, "light-0-color", "color", &["red", "#fff", "#gggggg", ""])?;
    page.change("a good colour", |page| page.enter("light-0-color", "#ff0000"))?;
    ensure!(page.message(ERROR)?.is_empty(), "a good colour does not end the message");
    page.must_be_content()
}

/// Enters bad values, each of which must be named and change nothing.
fn must_refuse(page: &mut Page, control: &str, name: &str, values: &[&str]) -> Result<()> {
    page.keep("before")?;
    for value in values {
        page.enter(control, value)?;
        let message = page.message(ERROR)?;
        let named = message.to_lowercase().contains(name);
        ensure!(named, "{value:?} as the {name} is answered with {message:?}");
        ensure!(page.shows(ERROR)?, "the message about {value:?} as the {name} cannot be seen");
        page.keep("after")?;
        let difference = page.difference("before", "after")?;
        ensure!(difference == 0.0, "{value:?} as the {name} changed the picture by {difference}");
    }
    Ok(())
}

/// No control asks for so many samples, so the module is asked itself.
pub(super) fn of_curves(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let asked = |samples: &str| {
        format!(
            "import('./pkg/wasm_demo.js').then(({{ Demo }}) => {{
                const demo = new Demo(document.createElement('canvas'), 8, 8);
                try {{ return String(demo.curve(0, {samples}).length); }} catch (refusal) {{ return refusal; }}
            }})"
        )
    };
    for samples in ["0", "1", "10001", "4294967295"] {
        let answer = page.text(&asked(samples))?;
        ensure!(answer.contains("number of samples"), "{samples} samples are answered with {answer:?}");
    }
    let answer = page.text(&asked("10000"))?;
    ensure!(answer == "20000", "10000 samples are answered with {answer:?}");
    page.must_be_content()
}
