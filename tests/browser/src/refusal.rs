//! Values that a light cannot take.

use anyhow::{Result, ensure};

use crate::Visitor;
use browser::Page;

const FIELD: &str = "light-field-number";
const ERROR: &str = "light-error";

pub(crate) fn is_told_and_harmless(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let good = page.value(FIELD)?;
    ensure!(page.message(ERROR)?.is_empty(), "a light that is fine has an error");
    must_refuse(&mut page, FIELD, "field angle", &["400", "0", "-10"])?;
    page.enter(FIELD, good)?;
    let message = page.message(ERROR)?;
    ensure!(message.is_empty(), "a field angle of {good} is answered with {message:?}");
    page.must_be_content()
}

pub(crate) fn are_all_told(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    must_refuse(&mut page, "light-intensity-number", "intensity", &["-1", "1e40"])?;
    page.enter("light-fixture", "ARRI L7-C")?;
    must_refuse(&mut page, "light-zoom-number", "zoom", &["5", "5000", "-15"])?;
    // A colour picker cannot hold anything but a colour, so the input is changed to a text field.
    page.ask("document.getElementById('light-color').type = 'text'")?;
    must_refuse(&mut page, "light-color", "color", &["red", "#fff", "#gggggg", ""])?;
    page.change("a good colour", |page| page.enter("light-color", "#ff0000"))?;
    ensure!(page.message(ERROR)?.is_empty(), "a good colour does not end the message");
    page.must_be_content()
}

/// Enters bad values. The message must name each of them, and the picture must not change.
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

/// A cleared field is not refused, because the visitor is about to type. A field that is left shows
/// the value in force.
pub(crate) fn ends_with_the_field(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    page.enter("light-fixture", "ARRI L7-C")?;
    for (field, error) in [
        ("light-beam-number", ERROR),
        (FIELD, ERROR),
        ("light-zoom-number", ERROR),
        ("light-intensity-number", ERROR),
    ] {
        must_forgive(&mut page, field, error)?;
    }
    page.must_be_content()?;
    let mut page = visitor.ready_at("#compare?half=10")?;
    must_forgive(&mut page, "half-angle-number", "half-angle-error")?;
    page.must_be_content()
}

fn must_forgive(page: &mut Page, field: &str, error: &str) -> Result<()> {
    let valid = format!("document.getElementById('{field}').getAttribute('aria-invalid') !== 'true'");
    let good = page.value(field)?;
    page.enter(field, "")?;
    let told = page.message(error)?;
    ensure!(told.is_empty() && page.holds(&valid)?, "{field}, cleared, is answered with {told:?}");
    leave(page, field)?;
    ensure!(page.value(field)? == good, "{field}, left empty, shows {}", page.value(field)?);

    page.enter(field, "-3")?;
    ensure!(!page.message(error)?.is_empty() && !page.holds(&valid)?, "-3 is taken for {field}");
    page.enter(field, "")?;
    let told = page.message(error)?;
    ensure!(told.is_empty() && page.holds(&valid)?, "{field}, cleared of -3, is answered with {told:?}");

    page.enter(field, "-3e38")?;
    let told = page.message(error)?;
    ensure!(told.contains("= -3e38: "), "-3e38 as {field} is answered with {told:?}");
    leave(page, field)?;
    let told = page.message(error)?;
    ensure!(told.is_empty() && page.holds(&valid)?, "{field} is left, and the message stays: {told:?}");
    ensure!(page.value(field)? == good, "{field}, left with -3e38, shows {}", page.value(field)?);

    // A text that is no number is refused while it is in the field: the browser distinguishes it
    // from an empty field. It has no digit, because some browsers type one character after another.
    page.ask(&format!(
        "(() => {{ const field = document.getElementById('{field}'); field.focus(); field.select(); }})()"
    ))?;
    page.type_text("e")?;
    page.press("Enter", 13)?;
    let told = page.message(error)?;
    ensure!(told.contains("= NaN: "), "e as {field} is answered with {told:?}");
    leave(page, field)?;
    ensure!(page.message(error)?.is_empty() && page.value(field)? == good, "e stays in {field}");
    Ok(())
}

fn leave(page: &mut Page, field: &str) -> Result<()> {
    page.ask(&format!("document.getElementById('{field}').blur()"))?;
    page.settle()
}

/// If a number format refuses a light, the message is shown beside the format and the format in use
/// stays chosen. A light that is changed later is refused under its own control.
pub(crate) fn of_a_format_stands_by_itself(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    page.enter("light-beam-number", "1")?;
    page.enter("format", "fx16")?;
    let told = page.message("stage-error")?;
    ensure!(
        told.contains("16-bit fixed point cannot hold light 1") && page.shows("stage-error")?,
        "{told:?}"
    );
    ensure!(page.message(ERROR)?.is_empty(), "the format's refusal stands under a control of the light");
    ensure!(page.text("document.getElementById('format').value")? == "f32", "the list shows another format");
    page.enter("light-beam-number", "30")?;
    ensure!(page.message("stage-error")?.is_empty(), "the format's refusal stays");
    page.enter("format", "fx16")?;
    page.enter("light-beam-number", "1")?;
    let under = format!(
        "document.getElementById('{ERROR}').previousElementSibling.contains(document.getElementById('light-beam-number'))"
    );
    ensure!(page.message(ERROR)?.contains("outer angle") && page.holds(&under)?, "{}", page.message(ERROR)?);
    page.must_be_content()
}

/// No control allows these numbers of samples, so the test calls the module directly.
pub(crate) fn of_curves(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let asked = |samples: &str| {
        format!(
            "import('./pkg/wasm_demo.js').then(({{ Stage }}) => {{
                const stage = new Stage(8, 8);
                try {{ return String(stage.curve(0, {samples}).length); }} catch (refusal) {{ return refusal; }}
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
