//! A failure is reported on the page, and stops only the parts that depend on what has failed. A
//! failure may also be written to the console, so that the tests of failures look at what is
//! visible.

use anyhow::{Context, Result, ensure};

use crate::{STILL, Visitor};
use browser::Page;
use tools::demo::site;
use tools::project;

pub(crate) fn without_simd(visitor: &mut Visitor) -> Result<()> {
    is_told(visitor, "WebAssembly.validate = () => false", "simd")
}

pub(crate) fn without_canvas(visitor: &mut Visitor) -> Result<()> {
    is_told(visitor, "HTMLCanvasElement.prototype.getContext = () => null", "canvas")
}

fn is_told(visitor: &mut Visitor, script: &str, cause: &str) -> Result<()> {
    let mut page = visitor.failed(script)?;
    let message = page.message("failure")?;
    ensure!(message.to_lowercase().contains(cause), "the message does not name {cause}: {message:?}");
    ensure!(page.shows("failure")?, "the message cannot be seen: {message:?}");
    Ok(())
}

/// The page is opened as a file, without a server.
pub(crate) fn from_a_file(visitor: &mut Visitor) -> Result<()> {
    let file = project::target().join("demo/index.html");
    let mut page = visitor.browser.open(&format!("file://{}", file.display()), "")?;
    ensure!(page.state()? == "failed", "the page is as if nothing were wrong");
    let message = page.message("failure")?;
    ensure!(message.contains("cargo demo") && page.shows("failure")?, "the message is {message:?}");
    Ok(())
}

/// Each view of the navigation opens, and is the only view that is shown.
pub(crate) fn of_no_view(visitor: &mut Visitor) -> Result<()> {
    for view in site::built_views() {
        let mut page = visitor.ready_at(&format!("#{view}?play=none"))?;
        let shown = page.number("document.querySelectorAll('main > :not([hidden])').length")?;
        let current = page.text("document.querySelector('.views [aria-current]').hash")?;
        ensure!(shown == 1.0 && current == format!("#{view}"), "{view} shows {shown} views, and {current}");
        page.must_be_content()?;
    }
    Ok(())
}

/// The connection is lost after the page has loaded, and later returns. What was not loaded says so
/// in its place, the stage lives on, and a retry succeeds as soon as there is a connection.
pub(crate) fn of_the_connection(visitor: &mut Visitor) -> Result<()> {
    const VIEWS: [(&str, &str); 3] = [("compare", "comparison"), ("museum", "museum"), ("chip", "chip")];
    let mut page = visitor.ready()?;
    page.set_offline(true)?;
    let views = VIEWS.into_iter().filter(|(view, _)| site::built_views().any(|built| built == *view));
    for (view, id) in views.clone() {
        open(&mut page, view)?;
        page.ask("probe.until(() => probe.visible('absent'))")?;
        let message = page.message("absent-reason")?;
        ensure!(message.contains("could not be loaded") && message.contains("connection"), "{message:?}");
        ensure!(!page.shows(id)?, "{view} is shown although it was not loaded");
        // A retry without a connection fails again.
        press(&mut page, "absent-retry")?;
        page.ask("probe.until(() => probe.visible('absent'))")?;
    }
    open(&mut page, "stage")?;
    page.settle()?;
    ensure!(page.shows("view")? && !page.shows("absent")?, "the stage is gone, too");
    page.change("a beam, offline", |page| page.enter("light-beam-number", 15))?;
    works(&mut page)?;
    page.ask("document.getElementById('price').scrollIntoView()")?;
    page.ask("probe.until(() => document.querySelector('#price > button'))")?;
    let message = page.message("price")?;
    ensure!(message.contains("could not be loaded") && page.shows("price")?, "the price says {message:?}");

    page.set_offline(false)?;
    page.ask("document.querySelector('#price > button').click()")?;
    page.ask("probe.until(() => document.querySelector('#price-picked b'))").context("the price is lost")?;
    for (view, id) in views {
        open(&mut page, view)?;
        page.ask(&format!("probe.until(() => luminaire.{id} && probe.visible('{id}'))"))
            .with_context(|| format!("{view} does not come back"))?;
        ensure!(!page.shows("absent")?, "{view} is there, and is told to be absent");
    }
    Ok(())
}

/// What draws in fixed point is loaded with the first such picture. Without a connection the page says
/// so, and the picture stays.
pub(crate) fn of_fixed_point(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let early = page.requests()?.iter().find(|request| request.contains("fixed")).cloned();
    ensure!(early.is_none(), "{early:?} is loaded before a picture in fixed point");
    page.set_offline(true)?;
    page.enter("format", "fx16")?;
    page.ask("probe.until(() => probe.text('stage-error') !== '')")?;
    let message = page.message("stage-error")?;
    ensure!(message.contains("could not be loaded") && message.contains("connection"), "{message:?}");
    works(&mut page)?;
    page.enter("format", "f32")?;
    page.settle()?;
    ensure!(page.message("stage-error")?.is_empty(), "f32 does not end the message");
    page.change("a beam, offline", |page| page.enter("light-beam-number", 15))?;

    page.set_offline(false)?;
    page.change("fixed point, with a connection", |page| page.enter("format", "fx16"))?;
    ensure!(page.message("stage-error")?.is_empty(), "{}", page.message("stage-error")?);
    works(&mut page)
}

fn open(page: &mut Page, view: &str) -> Result<()> {
    page.ask(&format!("document.querySelector('.views a[href=\"#{view}\"]').click()")).map(drop)
}

fn press(page: &mut Page, id: &str) -> Result<()> {
    page.ask(&format!("document.getElementById('{id}').click()")).map(drop)
}

/// Failures of parts that no picture depends on.
pub(crate) fn of_decorations(visitor: &mut Visitor) -> Result<()> {
    const NO_CURVE: &str = "document.createElementNS = () => { throw new Error('no curve') }";
    const NO_LIST: &str = "window.fetch = ((fetch) => (what, ...more) => String(what).endsWith('.json')
        ? Promise.reject(new TypeError('no list')) : fetch(what, ...more))(window.fetch.bind(window))";
    const NO_CLOCK: &str = "Object.defineProperty(window, 'performance', { get: () => undefined })";
    const NO_READOUT: &str = "Float64Array.from = () => { throw new Error('no median') }";
    for (view, script, place, words) in [
        (STILL, NO_CURVE, "trouble", "no curve"),
        ("#compare?half=10", NO_LIST, "prices-note", "no list"),
        (STILL, NO_CLOCK, "failure", ""),
    ] {
        let mut page = visitor.ready_with(view, script)?;
        works(&mut page)?;
        let told = format!("document.getElementById('{place}').textContent.includes('{words}')");
        page.ask(&format!("probe.until(() => {told})")).with_context(|| format!("{script} is not told"))?;
    }
    let mut page = visitor.ready()?;
    page.ask(NO_READOUT)?;
    page.change("a beam, without a readout", |page| page.enter("light-beam-number", 15))?;
    works(&mut page)?;
    ensure!(page.message("trouble")?.contains("no median"), "a readout that fails is not told");
    Ok(())
}

/// A crash of the module stops the page. Errors of anything else do not.
pub(crate) fn of_the_module(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    for harmless in ["new Error('a fault')", "'a refusal'", "new RangeError('too far')"] {
        page.ask(&format!("reportError({harmless})"))?;
        page.ask(&format!("void Promise.reject({harmless})"))?;
        page.settle()?;
        works(&mut page)?;
        ensure!(page.shows("trouble")?, "{harmless} is not told");
    }
    page.change("a beam, after faults", |page| page.enter("light-beam-number", 15))?;
    for deadly in [
        "reportError(new WebAssembly.RuntimeError('unreachable'))",
        "void Promise.reject(new WebAssembly.RuntimeError('unreachable'))",
        "dispatchEvent(new CustomEvent('luminaire-panic', { detail: 'unreachable' }))",
    ] {
        let mut page = visitor.ready()?;
        page.ask(deadly)?;
        page.ask("probe.until(() => document.body.dataset.state === 'failed')")?;
        let message = page.message("failure")?;
        ensure!(message.contains("unreachable") && message.contains("Reload"), "the message is {message:?}");
        ensure!(page.holds("document.querySelector('main').inert")?, "{deadly} leaves dead controls");
    }
    Ok(())
}

fn works(page: &mut Page) -> Result<()> {
    ensure!(page.state()? == "ready", "the demo has stopped: {}", page.message("failure")?);
    ensure!(!page.holds("document.querySelector('main').inert")?, "the demo takes no input");
    ensure!(!page.shows("view")? || page.lit_share()? > 0.0, "the picture is black");
    Ok(())
}
