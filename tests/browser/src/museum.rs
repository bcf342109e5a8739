//! The museum: every exhibit shows its fault, with the figures that the host computes.

use anyhow::{Context, Result, ensure};
use luminaire_museum::{ALL, Exhibit, Picture, Side};
use serde_json::Value;

use crate::Visitor;
use browser::Page;

/// Pixels on a side of a picture of the page.
const SIZE: u32 = 200;

pub(crate) fn shows_every_exhibit(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#museum?exhibit=beam-or-field")?;
    ensure!(page.shows("museum")? && !page.shows("view")?, "the address does not open the museum");
    let names = page.ask("luminaire.museum.names")?;
    let names: Vec<_> = names.as_array().context("no list of exhibits")?.iter().map(Value::as_str).collect();
    ensure!(names == ALL.iter().map(|exhibit| Some(exhibit.name)).collect::<Vec<_>>(), "exhibits: {names:?}");
    for exhibit in &ALL {
        change(&mut page, exhibit.name, |page| {
            page.ask(&format!("document.getElementById('exhibit-of-{}').click()", exhibit.name)).map(drop)
        })?;
        let told = page.message("exhibit-title")?;
        ensure!(told == exhibit.title, "{} is told as {told:?}", exhibit.name);
        agrees_with_the_host(&mut page, exhibit, exhibit.control.start)?;
        let hash = page.text("probe.until(() => location.hash.includes('at=')).then(() => location.hash)");
        ensure!(hash?.starts_with("#museum?exhibit="), "the address is not that of the museum");
    }
    // Small pictures are drawn one after the other.
    page.ask(
        "probe.until(() => [...document.querySelectorAll('.exhibits canvas')].every((c) => c.width === 48))",
    )?;
    page.must_be_content()
}

pub(crate) fn control_changes_the_errors(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#museum?exhibit=gltf&at=0.5")?;
    let [exhibit, ..] = &ALL;
    agrees_with_the_host(&mut page, exhibit, 0.5)?;
    let narrow = page.message("exhibit-largest-0")?;
    change(&mut page, "the slider", |page| page.enter("exhibit-value", 2_f64.log10()))?;
    agrees_with_the_host(&mut page, exhibit, 2.0)?;
    let wide = page.message("exhibit-largest-0")?;
    ensure!(narrow != wide, "half a degree and two degrees have the same error, {wide}");
    let agrees_at = exhibit.agrees_at.context("both are never right")?;
    change(&mut page, "the button", |page| {
        page.ask("document.getElementById('exhibit-agrees').click()").map(drop)
    })?;
    agrees_with_the_host(&mut page, exhibit, agrees_at)?;
    change(&mut page, "an arrow key", |page| {
        page.ask("document.getElementById('exhibit-of-gltf').focus()")?;
        page.press("ArrowDown", 40)
    })?;
    ensure!(page.text("luminaire.museum.state.exhibit")? == ALL[1].name, "the arrow leads nowhere");
    page.must_be_content()
}

pub(crate) fn bad_values_are_refused(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#museum?exhibit=none&at=1e9")?;
    let told = page.message("exhibit-error")?;
    ensure!(told.contains("expected 0.1 to 20"), "a value of the address is answered with {told:?}");
    let before = page.text("JSON.stringify(luminaire.museum.state)")?;
    for value in ["0", "-1", "21", "1e40"] {
        page.enter("exhibit-number", value)?;
        let told = page.message("exhibit-error")?;
        ensure!(told.contains("Half angle"), "{value} is answered with {told:?}");
        let after = page.text("JSON.stringify(luminaire.museum.state)")?;
        ensure!(after == before, "{value} changed the pictures");
    }
    let mut page = visitor.ready_at("#museum?exhibit=none")?;
    let told = page.message("exhibit-error")?;
    ensure!(told.contains("exhibit = \"none\""), "an exhibit of the address is answered with {told:?}");
    page.must_be_content()
}

/// What a screen reader finds: names of landmarks, pictures and controls.
pub(crate) fn is_named(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#museum")?;
    let unnamed = page.text(
        "Array.from(document.querySelectorAll('#museum canvas:not([aria-hidden]), #museum input[type=number]')) \
         .filter((item) => !item.getAttribute('aria-label')).map((item) => item.id).join()",
    )?;
    ensure!(unnamed.is_empty(), "without a name: {unnamed}");
    let names = page.text(
        "Array.from(document.querySelectorAll('#museum [aria-labelledby]'), \
         (item) => document.getElementById(item.getAttribute('aria-labelledby')).textContent).join('|')",
    )?;
    let names: Vec<_> = names.split('|').collect();
    ensure!(names.len() == 2 && names[0] != names[1] && !names.contains(&""), "landmarks: {names:?}");
    let integer = page.ask(
        "Array.from(document.querySelectorAll('.sides canvas'), (c) => c.getBoundingClientRect().width / c.width)",
    )?;
    let scales = integer.as_array().context("no pictures")?;
    ensure!(
        scales.len() == 4 && scales.iter().all(|scale| *scale == 1),
        "scales of the pictures: {scales:?}"
    );
    page.must_be_content()
}

/// The errors on the page are those of the host.
fn agrees_with_the_host(page: &mut Page, exhibit: &Exhibit, value: f32) -> Result<()> {
    let state = page.ask("luminaire.museum.state")?;
    ensure!(state["exhibit"] == exhibit.name, "{} was asked for: {state}", exhibit.name);
    let shown = state["value"].as_f64().context("no value")?;
    ensure!((shown - f64::from(value)).abs() < 1e-3 * shown.abs().max(1e-3), "{value} is shown as {shown}");
    let beam = (exhibit.beam)(shown as f32).with_context(|| exhibit.name)?;
    let picture = Picture::of(&beam, SIZE).with_context(|| exhibit.name)?;
    for (side, found) in
        [Side::Faulty, Side::Ours].into_iter().zip(state["sides"].as_array().context("no sides")?)
    {
        let errors = picture.errors(side);
        let largest = found["largest"].as_f64().context("no error")?;
        let name = exhibit.name;
        ensure!(
            (largest - errors.largest).abs() <= 1e-6 * errors.largest,
            "{name}: {found}, {}",
            errors.largest
        );
        ensure!(found["undefined"] == errors.undefined, "{name}: {found}, {} undefined", errors.undefined);
    }
    Ok(())
}

/// Runs `act`, which must redraw the museum.
fn change(page: &mut Page, what: &str, act: impl FnOnce(&mut Page) -> Result<()>) -> Result<()> {
    let drawn = page.number("luminaire.drawn")?;
    act(page)?;
    page.ask(&format!("probe.redrawn({drawn})")).map(drop).with_context(|| format!("{what} has no effect"))
}
