//! The times of the passes belong to the last picture. A time of an earlier picture is marked as
//! kept.

use anyhow::{Context, Result, ensure};

use crate::Visitor;
use browser::Page;

pub(crate) fn adds_up(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    must_add_up(&mut page, &[])?;
    page.change("the beam", |page| page.enter("light-beam-number", 12))?;
    must_add_up(&mut page, &[])?;
    let middle = page.middle("view")?;
    page.change("a drag", |page| page.drag(middle, (60.0, 10.0)))?;
    must_add_up(&mut page, &["shadows"])?;
    page.enter("format", "fx16")?;
    must_add_up(&mut page, &[])?;

    let mut page = visitor.ready_at("#stage?play=none&scene=three-point")?;
    must_add_up(&mut page, &[])?;
    let drawn = page.number("luminaire.drawn")?;
    page.ask("document.getElementById('scene-turntable').click()")?;
    page.ask("document.getElementById('play').click()")?;
    page.ask(&format!("probe.until(() => luminaire.drawn > {drawn} + 8)"))?;
    must_add_up(&mut page, &["geometry"])?;
    let shadows = page.message("shadows-ms")?;
    ensure!(shadows == "–", "a scene without shadows has {shadows} of the one before");
    page.must_be_content()
}

/// The times of the passes that are not marked as kept add up to the time of the frame. `kept`
/// names the passes that must be marked.
fn must_add_up(page: &mut Page, kept: &[&str]) -> Result<()> {
    // All times are read in one call, because the next picture has other times.
    let told = page.ask(
        "Object.fromEntries(['geometry', 'shadows', 'lighting', 'encode', 'transfer', 'show', 'frame'].map((pass) => {
            const place = document.getElementById(`${pass}-ms`);
            return [pass, place && { text: place.textContent, isGrey: place.classList.contains('kept') }];
        }))",
    )?;
    let mut sum = 0.0;
    for pass in ["geometry", "shadows", "lighting", "encode", "transfer", "show"] {
        let Some(text) = told[pass]["text"].as_str() else { continue };
        let is_kept = text.ends_with(" kept");
        ensure!(is_kept == kept.contains(&pass), "{pass} is told as {text:?}");
        ensure!(!is_kept || told[pass]["isGrey"] == true, "{pass}, which was kept, looks like the others");
        if !is_kept && text != "–" {
            sum += milliseconds(text)?;
        }
    }
    let frame = milliseconds(told["frame"]["text"].as_str().context("there is no frame")?)?;
    ensure!((sum - frame).abs() <= 0.01 * frame, "passes of {sum} ms make a frame of {frame} ms");
    Ok(())
}

fn milliseconds(told: &str) -> Result<f64> {
    told.strip_suffix(" ms")
        .and_then(|number| number.parse().ok())
        .with_context(|| format!("a time is {told:?}"))
}
