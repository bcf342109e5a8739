//! The first picture.

use anyhow::{Result, ensure};

use crate::{STILL, Visitor};

pub(crate) fn becomes_ready(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    ensure!(page.holds("window.crossOriginIsolated")?, "the page is not crossOriginIsolated");
    ensure!(!page.shows("failure")?, "#failure is visible though nothing failed");
    page.must_be_content()
}

/// The picture differs visibly from the picture with every light switched off, which shows ambient
/// light only.
pub(crate) fn is_lit(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let colours = page.number("probe.survey().colours")?;
    ensure!(colours > 16.0, "the picture has only {colours} colours");
    page.keep("lit")?;
    for light in 0..3 {
        page.ask(&format!("document.getElementById('light-{light}-on').click()"))?;
    }
    page.settle()?;
    page.keep("unlit")?;
    let (brightest, share) = (page.difference("lit", "unlit")?, page.number("probe.share('lit', 'unlit')")?);
    ensure!(brightest > 128.0, "the lights add at most {brightest} codes");
    ensure!(share > 0.2, "the lights reach a share of only {share} of the pixels");
    page.must_be_content()
}

/// The canvas refuses a picture once. The next draw must show it, although nothing has changed
/// since.
pub(crate) fn is_shown_again(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let (redraw, drawn) = ("luminaire.redraw()", page.number("luminaire.drawn")?);
    let refused = page.holds(
        "(async () => {
            const canvas = CanvasRenderingContext2D.prototype, put = canvas.putImageData;
            canvas.putImageData = function (...picture) {
                if (this.canvas.id === 'view') throw new Error('out of memory');
                put.apply(this, picture);
            };
            document.getElementById('light-0-on').click();
            await luminaire.redraw();
            canvas.putImageData = put;
            return document.getElementById('stage-error').textContent.includes('out of memory');
        })()",
    )?;
    ensure!(refused, "a canvas that refuses is not told");
    ensure!(page.number("luminaire.drawn")? == drawn, "a picture that was refused counts as drawn");
    page.ask(redraw)?;
    ensure!(page.number("luminaire.drawn")? == drawn + 1.0, "the refused picture is not shown again");
    page.ask(redraw)?;
    ensure!(page.number("luminaire.drawn")? == drawn + 1.0, "a picture that was shown is shown again");
    page.must_be_content()
}

pub(crate) fn has_the_asked_size(visitor: &mut Visitor) -> Result<()> {
    for (query, width, height) in [("?rest=0", 960, 540), ("?width=320&height=180", 320, 180)] {
        let mut page = visitor.ready_at(&format!("{query}{STILL}"))?;
        let size =
            page.text("(({ width, height }) => `${width}x${height}`)(document.getElementById('view'))")?;
        ensure!(size == format!("{width}x{height}"), "{width}x{height} was asked for: {size}");
        let pixels = page.number("probe.survey().pixels")?;
        ensure!(pixels == f64::from(width * height), "{width}x{height} was asked for: {pixels} pixels");
        page.must_be_content()?;
    }
    Ok(())
}
