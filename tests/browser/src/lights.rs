//! The lights in the picture and on the desk: they are dragged, aimed, zoomed and lit by lumens.

use anyhow::{Context, Result, ensure};

use crate::Visitor;
use browser::Page;

/// A scene of one light, paused, with the lights in the picture.
const ONE: &str = "#stage?scene=bare-spot&play=none";

/// The pool follows the mouse, and one undo takes the whole drag back.
pub(crate) fn are_aimed_by_mouse(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at(ONE)?;
    let aim = handle(&mut page, "handle-aim")?;
    page.change("a drag of the pool", |page| page.drag(aim, (60.0, 10.0)))?;
    let after = page.middle("handle-aim")?;
    let way = (after.0 - aim.0 - 60.0).abs() + (after.1 - aim.1 - 10.0).abs();
    ensure!(way < 4.0, "the pool went from {aim:?} to {after:?}");
    page.ask("probe.until(() => location.hash.includes(':t'))").context("the address has no aim")?;
    page.change("undo", |page| page.ask("document.getElementById('undo').click()").map(drop))?;
    let back = page.middle("handle-aim")?;
    ensure!((back.0 - aim.0).abs() < 1.0, "one undo leads to {back:?}, not to {aim:?}");
    ensure!(page.holds("document.getElementById('undo').disabled")?, "a drag takes more than one undo");
    page.must_be_content()
}

/// The wheel over the pool zooms the light by 8 % a notch: its flux stays, and its intensity falls. The
/// page says how many notches it was: WebKit's driver turns the wheel by less, and the other way.
pub(crate) fn are_zoomed_by_wheel(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at(ONE)?;
    let aim = handle(&mut page, "handle-aim")?;
    let (field, candela) = (page.value("light-field-number")?, page.value("light-intensity-number")?);
    let flux = flux(&mut page)?;
    page.ask(
        "addEventListener('wheel', (event) => (window.notches = event.deltaY / [100, 3, 1][event.deltaMode]), true)",
    )?;
    page.ask("document.getElementById('handle-aim').focus()")?;
    page.change("the wheel", |page| page.wheel(aim, 100.0))?;
    let notches = page.number("window.notches")?;
    ensure!(notches.abs() > 0.1, "the wheel turns by {notches} notches");
    let (wider, fainter) = (page.value("light-field-number")?, page.value("light-intensity-number")?);
    let zoom = wider / field;
    ensure!(
        (zoom / 1.08_f64.powf(notches) - 1.0).abs() < 0.002,
        "the wheel turns {field} into {wider} degrees"
    );
    ensure!((candela / fainter / zoom.powi(2) - 1.0).abs() < 0.01, "{candela} candela become {fainter}");
    ensure!(flux == self::flux(&mut page)?, "the flux was {flux}, and is {}", self::flux(&mut page)?);
    page.must_be_content()
}

/// Waits for a handle, which the page loads late. Returns its middle.
fn handle(page: &mut Page, id: &str) -> Result<(f64, f64)> {
    page.ask(&format!("probe.until(() => document.getElementById('{id}') && probe.visible('{id}'))"))?;
    page.middle(id)
}

fn flux(page: &mut Page) -> Result<String> {
    let told = page.message("light-photometry")?;
    let (flux, _) = told.split_once(" lm,").with_context(|| format!("no flux is told: {told:?}"))?;
    Ok(flux.to_owned())
}

/// A click selects a light and moves nothing; the arrow keys move it. The switch hides all lights.
pub(crate) fn are_moved_by_keys(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?scene=show&play=none")?;
    let third = handle(&mut page, "handle-3")?;
    page.drag(third, (1.0, 1.0))?;
    page.settle()?;
    ensure!(page.message("panel-title")? == "4 moving head (beam)", "{}", page.message("panel-title")?);
    let after = page.middle("handle-3")?;
    ensure!(
        (after.0 - third.0).abs() + (after.1 - third.1).abs() < 1.0,
        "a click moves the light to {after:?}"
    );
    let x = page.value("light-x")?;
    ensure!(page.text("document.activeElement.id")? == "handle-3", "the light has no focus");
    page.change("an arrow key", |page| page.press("ArrowRight", 39))?;
    ensure!(page.value("light-x")? > x + 0.05, "the light stays at {x}");
    ensure!(page.message("light-way")?.starts_with("The scene moves the aim"), "a move ends the sweep");
    page.change("an aim", |page| page.enter("light-aim-y", 0.5))?;
    ensure!(page.message("light-way")? == "Moved by you.", "an aim does not end the sweep");
    page.change("the way back", |page| page.ask("document.getElementById('light-back').click()").map(drop))?;
    ensure!(page.value("light-x")? == x, "the light is not put back");
    page.ask("document.getElementById('handles-shown').click()")?;
    ensure!(!page.shows("handle-3")?, "the switch leaves the lights in the picture");
    page.ask("probe.until(() => location.hash.endsWith('&handles=0'))").context("the address shows them")?;
    page.must_be_content()
}

/// A dot on the curve sets its angle, and the other angle stays. A click on a dot sets nothing.
pub(crate) fn angles_are_set_on_the_curve(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let (beam, field) = (page.value("light-beam-number")?, page.value("light-field-number")?);
    page.ask("probe.until(() => document.querySelector('#curve [role=slider]'))")?;
    page.ask("document.querySelector('#curve [role=slider] .dot').id = 'first-dot'")?;
    let dot = page.middle("first-dot")?;
    page.drag(dot, (2.0, 0.0))?;
    page.settle()?;
    ensure!(page.value("light-beam-number")? == beam, "a click on the dot sets the angle");
    page.ask("document.querySelector('#curve [role=slider]').focus()")?;
    page.change("a key", |page| page.press("ArrowLeft", 37))?;
    let narrower = page.value("light-beam-number")?;
    ensure!((narrower / beam - 0.99).abs() < 0.002, "a beam angle of {beam} becomes {narrower}");
    ensure!(page.value("light-field-number")? == field, "the field angle does not stay {field}");
    ensure!(page.text("document.getElementById('light-edge').value")? == "fitted", "the edge is not fitted");
    page.enter("light-field-number", 35)?;
    ensure!(page.value("light-beam-number")? == narrower, "a data sheet's two angles can't be typed");
    for edge in ["smooth", "inverted-power", "table"] {
        page.change(edge, |page| page.enter("light-edge", edge))?;
        ensure!(page.value("light-field-number")? == 35.0, "{edge} changes the field angle");
    }
    page.must_be_content()
}
