//! The check of the demo in a browser: `cargo demo --check` and `--screenshot`.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};

use crate::turntable::{self, Cores, Frame, LOADS, Load};
use crate::{Browser, Page};

/// Number of frames that the check draws. It reports their median time.
const FRAMES: u32 = 15;

/// Records when the page is ready to be used, which is when it shows its first picture.
const READY: &str = "document.addEventListener('DOMContentLoaded', () => {
    new MutationObserver(() => {
        if (document.body.dataset.state === 'ready') window.readyAfter ??= performance.now();
    }).observe(document.body, { attributes: true });
})";

/// Runs the page once, and writes a picture of it. Returns its measurements as one line.
pub fn check(browser: &mut dyn Browser, address: &str, screenshot: Option<&Path>) -> Result<String> {
    let mut page = browser.open(address, READY)?;
    page.ready()?;
    let ready = page.number("readyAfter")?;
    let scene = page.text("luminaire.scene")?;
    ensure!(!page.shows("view")? || page.lit_share()? > 0.0, "the page drew nothing: every pixel is black");
    if let Some(file) = screenshot {
        // Time for the small pictures of the scenes, and for times of more than one picture.
        page.ask("new Promise((resolve) => setTimeout(resolve, 3000))")?;
        page.ask("luminaire.comparison?.measured")?;
        fs::write(file, page.screenshot()?).with_context(|| format!("cannot write {}", file.display()))?;
    }
    // A picture that plays would take the workers' time.
    page.ask("['play', 'camera'].forEach((id) => { const box = document.getElementById(id); if (box.checked) box.click(); })")?;
    let times = frames(&mut page, &scene)?;
    page.must_be_content()?;
    Ok(format!("demo ok: the first picture after {ready:.0} ms; {times}"))
}

/// The frame times of a scene, in words. The turntable is timed under each of its loads.
fn frames(page: &mut Page, scene: &str) -> Result<String> {
    if scene != turntable::SCENE {
        let frame = turntable::frame(page, scene, FRAMES, "{}")?;
        let cores = turntable::cores(page, scene, FRAMES, "{}")?;
        return Ok(format!("{scene}: {}{}", in_words(frame), cores_in_words(cores)));
    }
    let load = |load: &Load| {
        let (frame, cores) = (load.time(page, FRAMES)?, load.cores(page, FRAMES)?);
        Ok(format!("{}: {}{}", load.name, in_words(frame), cores_in_words(cores)))
    };
    Ok(format!("{scene}: {}", LOADS.iter().map(load).collect::<Result<Vec<_>>>()?.join("; ")))
}

/// How many pictures workers draw that share each picture, of those of independent loops.
fn cores_in_words(Cores { workers, together, apart }: Cores) -> String {
    let share = 100.0 * together / apart;
    format!(", {together:.1} a second by {workers} workers, {share:.0} % of {workers} independent loops")
}

fn in_words(frame: Frame) -> String {
    match frame {
        Frame { at_rest: Some(at_rest), moving: Some(moving) } => {
            format!("{at_rest:.2} ms a frame, {moving:.2} ms with a moving camera")
        }
        Frame { moving: Some(moving), .. } => format!("{moving:.2} ms a frame with a moving camera"),
        _ => "nothing moves".to_owned(),
    }
}
