//! The comparison: the error of each form, and how the page reports it.

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::Visitor;
use browser::Page;

/// The address of the comparison of the two forms in f32.
const FORMS: &str = "#compare?left=f32-cosine&right=f32&half=10";

/// A price list with three rows.
const LIST: &str = r#"{"rows":[
    {"kernel":"lit","stage":"lit","format":"f32","error":{"codes":0.25,"kind":"searched"},
        "cost":{"cortex-m0":{"instructions":5000},"host":{"ns":2.5}}},
    {"kernel":"lit","stage":"lit","format":"f32-cosine","error":{"codes":0.5,"kind":"searched"},
        "cost":{"cortex-m0":{"instructions":2500},"host":{"ns":5}}},
    {"kernel":"soft","stage":"falloff","format":"f32","error":{"codes":1e-5,"kind":"exhaustive"},
        "cost":{"cortex-m0":{"instructions":428}}},
    {"kernel":"powf-libm","stage":"falloff","format":"rival","error":null,
        "cost":{"cortex-m0":{"instructions":9905}}}]}"#;

pub(crate) fn narrow_beam_parts_the_forms(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at(FORMS)?;
    ensure!(page.shows("comparison")? && !page.shows("view")?, "the address does not open the comparison");
    for side in 0..2 {
        let (picture, error) = (brightness(&mut page, side)?, largest(&mut page, side)?);
        ensure!(picture == (255.0, 0.0), "middle and corner of picture {side} are {picture:?}");
        ensure!(error < 1.0, "in a wide beam form {side} is off by {error} codes");
    }
    let slider = 0.05_f64.log10();
    change(&mut page, "the slider", |page| page.enter("half-angle", slider))?;
    let number = page.value("half-angle-number")?;
    ensure!((number - 0.05).abs() < 1e-6, "the slider went to 0.05 degrees, the number says {number}");
    let (cosine, versine) = (largest(&mut page, 0)?, largest(&mut page, 1)?);
    ensure!(cosine > 20.0, "the cosine form is off by only {cosine} codes at 0.05 degrees");
    ensure!(versine < 1.0, "the versine form is off by {versine} codes at 0.05 degrees");
    let told = [page.message("largest-0")?, page.message("largest-1")?];
    for (told, exact) in told.iter().zip([cosine, versine]) {
        let shown: f64 = told.parse().with_context(|| format!("the largest error is told as {told:?}"))?;
        ensure!((shown - exact).abs() <= 0.1 * exact, "{exact} codes are told as {told:?}");
    }
    for side in 0..2 {
        let differing = page.message(&format!("differing-{side}"))?;
        ensure!(differing.ends_with('%'), "the share of pixels that differ is told as {differing:?}");
    }
    let verdict = page.message("verdict")?;
    ensure!(verdict.starts_with("B is") && verdict.contains("more accurate"), "the verdict is {verdict:?}");
    page.must_be_content()
}

/// Every form shows a picture or a refusal in words at both ends of the slider and between, without
/// a panic.
pub(crate) fn every_form_answers_every_angle(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#compare")?;
    let forms = page.ask("probe.options('form-0')")?;
    let forms = forms.as_array().context("the forms are no list")?;
    ensure!(forms.len() > 4, "there are only the forms {forms:?}");
    for form in forms {
        page.enter("form-0", form.as_str().context("a form has no name")?)?;
        for half_angle in [0.002, 0.7, 60.0] {
            page.enter("half-angle-number", half_angle)?;
            let state = side(&mut page, 0)?;
            ensure!(state["form"] == *form, "{form} was asked for: {state}");
            let words = page.message("refusal-0")?;
            let answered =
                if words.is_empty() { state["largest"].is_number() } else { words.contains("at least") };
            ensure!(answered, "{form} at {half_angle} degrees: {words:?}, {state}");
        }
    }
    page.must_be_content()
}

pub(crate) fn divider_moves(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at(FORMS)?;
    let middle = page.middle("divider")?;
    let split = |page: &mut Page| -> Result<f64> {
        let place = page.value("divider")?;
        ensure!(place == page.value("errors-divider")?, "the two dividers are in two places");
        let clip = page.text("getComputedStyle(document.querySelector('#comparison .half')).clipPath")?;
        let expected = (100.0 - place).to_string();
        let shown = clip.replace("calc(", "").contains(&expected[..expected.len().min(4)]);
        ensure!(shown || place == 0.0, "the divider is at {place} %, the picture is cut by {clip}");
        Ok(place)
    };
    let start = split(&mut page)?;
    page.drag(middle, (90.0, 0.0))?;
    let dragged = split(&mut page)?;
    ensure!(dragged > start + 5.0, "dragging took the divider from {start} to {dragged}");
    page.ask("document.getElementById('divider').focus()")?;
    page.press("ArrowLeft", 37)?;
    let pressed = split(&mut page)?;
    ensure!(pressed < dragged, "the arrow took the divider from {dragged} to {pressed}");
    page.press("Home", 36)?;
    ensure!(split(&mut page)? == 0.0, "Home does not take the divider to the left edge");
    page.must_be_content()
}

pub(crate) fn refusal_is_told_with_a_remedy(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at(FORMS)?;
    page.enter("form-1", "fx16")?;
    ensure!(page.message("refusal-1")?.is_empty(), "a beam of 10 degrees is refused");
    page.enter("half-angle-number", 0.1)?;
    let words = page.message("refusal-1")?;
    ensure!(words.contains("Fx16") && words.contains("expected at least 1."), "the refusal says {words:?}");
    ensure!(page.shows("refusal-1")? && page.shows("widen-1")?, "the refusal cannot be seen");
    ensure!(page.message("refusal-0")?.is_empty(), "the other form is refused, too");
    ensure!(page.message("largest-1")? == "refused", "what is refused has an error");
    change(&mut page, "the remedy", |page| page.ask("document.getElementById('widen-1').click()").map(drop))?;
    ensure!(page.message("refusal-1")?.is_empty(), "the remedy is refused");
    let half_angle = page.value("half-angle-number")?;
    ensure!(half_angle > 0.65 && half_angle < 0.75, "the remedy is {half_angle} degrees");
    ensure!(largest(&mut page, 1)? < 1.0, "what is accepted is off by more than a code");
    page.must_be_content()
}

pub(crate) fn bad_values_are_harmless(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at(FORMS)?;
    let before = page.text("JSON.stringify(luminaire.comparison.sides)")?;
    for value in ["0", "-1", "0.0001", "200", "1e40"] {
        page.enter("half-angle-number", value)?;
        let message = page.message("half-angle-error")?;
        let told = message.contains("half angle") && message.contains("expected 0.002 to 60 degrees");
        ensure!(told, "a half angle of {value:?} is answered with {message:?}");
        let after = page.text("JSON.stringify(luminaire.comparison.sides)")?;
        ensure!(after == before, "a half angle of {value:?} changed the pictures");
    }
    page.enter("half-angle-number", 10)?;
    ensure!(page.message("half-angle-error")?.is_empty(), "a good half angle does not end the message");
    page.must_be_content()?;

    let mut page = visitor.ready_at("#compare?left=f16&right=&half=wide")?;
    ensure!(page.message("refusal-0")?.contains("form = \"f16\""), "a form of the address is not refused");
    ensure!(page.message("refusal-1")?.contains("form = \"\""), "no form at all is not refused");
    ensure!(page.message("half-angle-error")?.contains("NaN"), "a half angle of the address is not refused");
    ensure!(largest(&mut page, 0)? >= 0.0, "there is no picture");
    page.must_be_content()
}

pub(crate) fn scale_is_chosen(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#compare?left=f32-cosine&right=f32&half=0.1")?;
    let colours = |page: &mut Page| {
        page.text("document.getElementById('errors-0').toDataURL()").context("the errors have no picture")
    };
    let (automatic, end) = (colours(&mut page)?, page.message("tick-end")?);
    ensure!(end.starts_with("50 codes"), "errors of 46 codes have a scale to {end}");
    change(&mut page, "the scale", |page| page.enter("scale", 255))?;
    let end = page.message("tick-end")?;
    ensure!(end.starts_with("255 codes"), "a scale to 255 codes was asked for: {end}");
    ensure!(colours(&mut page)? != automatic, "the scale leaves the colours as they were");
    change(&mut page, "the automatic scale", |page| page.enter("scale", ""))?;
    ensure!(colours(&mut page)? == automatic, "the automatic scale does not come back");
    page.must_be_content()
}

pub(crate) fn is_reached_by_its_link(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    ensure!(page.shows("view")? && !page.shows("comparison")?, "the page does not open with the stage");
    let drawn = page.number("luminaire.drawn")?;
    page.ask("document.querySelector('.views a[href=\"#compare\"]').click()")?;
    page.ask(&format!("probe.redrawn({drawn})"))?;
    ensure!(page.shows("comparison")? && !page.shows("view")?, "the link does not show the comparison");
    let current = "document.querySelector('.views [aria-current]').textContent";
    ensure!(page.text(current)? == "Compare formats", "the link is not the current one");
    page.ask("document.querySelector('.views a[href=\"#stage\"]').click()")?;
    page.ask("probe.until(() => probe.visible('view'))").context("the way back does not show the stage")?;
    page.settle()?;
    ensure!(!page.shows("comparison")?, "the way back leaves the comparison in view");
    page.change("the hard edge, after coming back", |page| {
        let edge = page.text("document.getElementById('light-edge').value")?;
        page.enter("light-edge", if edge == "soft" { "hard" } else { "soft" })
    })?;
    page.must_be_content()
}

pub(crate) fn times_are_measured(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at(FORMS)?;
    page.ask("luminaire.comparison.measured")?;
    for side in 0..2 {
        let told = page.message(&format!("time-{side}"))?;
        let time: Option<f64> = told.strip_suffix(" ms").and_then(|number| number.parse().ok());
        ensure!(time.is_some_and(|time| time > 0.0), "the time of picture {side} is told as {told:?}");
    }
    page.must_be_content()
}

pub(crate) fn prices_stand_beside_the_errors(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_with(FORMS, &answering(LIST))?;
    let cells = |page: &mut Page, rows: &str| {
        page.text(&format!(
            "Array.from(document.querySelectorAll('{rows}'), (row) => row.innerText).join('|')"
        ))
    };
    let costs = cells(&mut page, "#costs tr")?;
    ensure!(
        costs.contains("Cortex-M0\t2,500\t5,000") && costs.contains("5 ns\t2.5 ns"),
        "the costs are {costs:?}"
    );
    let rows = cells(&mut page, "#prices tr.marked")?;
    ensure!(
        rows.contains("A\tlit, no attenuation\tf32-cosine\t0.5")
            && rows.contains("B\tlit, no attenuation\tf32\t0.25"),
        "marked: {rows:?}"
    );
    page.enter("half-angle-number", 0.1)?;
    let verdict = page.message("verdict")?;
    ensure!(verdict.ends_with("takes 2× the instructions."), "the verdict is {verdict:?}");
    // The list has no lit point for the power, so both forms are compared by their falloff alone.
    page.enter("form-0", "powf")?;
    let costs = cells(&mut page, "#costs tr")?;
    ensure!(costs.contains("Cortex-M0\t9,905\t428"), "the costs are {costs:?}");
    // The curve differs, too, so that the errors cannot be compared.
    let verdict = page.message("verdict")?;
    ensure!(
        verdict.contains("different curves") && !verdict.contains("more accurate"),
        "the verdict is {verdict:?}"
    );
    page.must_be_content()?;

    let mut page = visitor.ready_with(FORMS, &answering("null"))?;
    for place in ["costs-note", "prices-note"] {
        let words = page.message(place)?;
        ensure!(words.contains("cargo xtask measure"), "a list that is missing is told as {words:?}");
    }
    page.must_be_content()
}

/// A script that answers the page's request for the price list.
fn answering(list: &str) -> String {
    let list = Value::from(list);
    format!(
        "{{ const ask = window.fetch.bind(window); \
         window.fetch = (what, ...more) => String(what).endsWith('accuracy-vs-cost.json') \
         ? Promise.resolve(new Response({list})) : ask(what, ...more); }}"
    )
}

fn side(page: &mut Page, side: usize) -> Result<Value> {
    page.ask(&format!("luminaire.comparison.sides[{side}]"))
}

fn largest(page: &mut Page, number: usize) -> Result<f64> {
    let state = side(page, number)?;
    state["largest"].as_f64().with_context(|| format!("side {number} has no error: {state}"))
}

/// The codes of a picture's centre and of one corner, read from its canvas.
fn brightness(page: &mut Page, side: usize) -> Result<(f64, f64)> {
    let mut code = |place: &str| {
        page.number(&format!(
            "(() => {{ const c = document.getElementById('picture-{side}'); const at = {place}; \
             return c.getContext('2d').getImageData(at, at, 1, 1).data[0]; }})()"
        ))
    };
    Ok((code("c.width / 2")?, code("0")?))
}

/// Runs `act`, which must redraw the comparison.
fn change(page: &mut Page, what: &str, act: impl FnOnce(&mut Page) -> Result<()>) -> Result<()> {
    let drawn = page.number("luminaire.drawn")?;
    act(page)?;
    page.ask(&format!("probe.redrawn({drawn})")).map(drop).with_context(|| format!("{what} has no effect"))
}
