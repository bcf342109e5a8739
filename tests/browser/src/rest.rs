//! The resolution of the picture: that of the device while nothing moves.

use anyhow::{Result, ensure};
use browser::Page;

use crate::Visitor;

/// The pixels of the picture for each pixel of the device, along a row and along a column.
fn resolution(page: &mut Page) -> Result<[f64; 2]> {
    let along = |page: &mut Page, side: &str| {
        page.number(&format!(
            "(canvas => canvas.{side} / (canvas.getBoundingClientRect().{side} * devicePixelRatio))\
             (document.getElementById('view'))"
        ))
    };
    Ok([along(page, "width")?, along(page, "height")?])
}

pub(crate) fn has_the_resolution_of_the_device(visitor: &mut Visitor) -> Result<()> {
    for (width, height, density) in [(1280, 800, 1.0), (390, 844, 1.0), (800, 600, 2.0)] {
        let mut page = visitor.ready_at("?#stage?play=none&scene=three-point")?;
        page.resize_on(width, height, density)?;
        // The window may have its size a moment later, and the picture at rest has its own after a
        // while in which nothing changed.
        page.ask(&format!(
            "(async () => {{
                const view = document.getElementById('view');
                const isExact = () => innerWidth === {width} && devicePixelRatio === {density}
                    && Math.abs(view.width - view.getBoundingClientRect().width * devicePixelRatio) <= 1;
                do {{
                    await probe.until(isExact);
                    await probe.settle();
                }} while (!isExact());
            }})()"
        ))?;
        let found = resolution(&mut page)?;
        let is_right = found.iter().all(|along| (along - 1.0).abs() < 0.01);
        ensure!(is_right, "{width} x {height} at density {density}: expected 1, found {found:?}");
        ensure!(page.lit_share()? > 0.0, "the picture at rest is black");
        page.must_be_content()?;
    }
    Ok(())
}

/// Whatever changes the picture returns to the size of pictures that move, until it is at rest
/// again.
pub(crate) fn ends_with_a_change(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("?#stage?play=none&scene=three-point")?;
    page.resize_on(1280, 800, 2.0)?;
    let width = "document.getElementById('view').width";
    for act in [
        "document.getElementById('light-0-on').click()",
        "probe.enter('exposure', 1)",
        "document.getElementById('view').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' }))",
    ] {
        page.ask(&format!("probe.until(() => {width} > 960)"))?;
        let drawn = page.number("luminaire.drawn")?;
        let widths = page.text(&format!(
            "(async () => {{
                {act};
                await probe.until(() => luminaire.drawn > {drawn});
                const moving = {width};
                await probe.until(() => {width} > 960);
                return `${{moving}} ${{luminaire.drawn - {drawn}}}`;
            }})()"
        ))?;
        ensure!(widths == "960 1", "{act}: expected 960 pixels in 1 picture, found {widths}");
    }
    page.must_be_content()?;

    // What plays has the size of pictures that move.
    let mut page =
        visitor.browser.open(&format!("{}#stage?play=lights&scene=turntable", visitor.address), "")?;
    page.ready()?;
    page.ask("probe.until(() => luminaire.drawn > 10)")?;
    ensure!(page.number(width)? == 960.0, "a picture that plays has another size");
    page.must_be_content()
}
