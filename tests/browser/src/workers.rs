//! The picture is drawn by workers: by any number of them with the same bits, or by the page itself,
//! and never so that the page is in the way of its visitor.

use anyhow::{Context, Result, ensure};

use crate::Visitor;
use browser::Page;

/// Pictures that need all passes: with haze, gobos, shadows, dither, fixed point and maps.
const PICTURES: [&str; 4] = [
    "scene=show&at=2.5/0&effects=dither",
    "scene=three-point&format=fx16&effects=haze/dither",
    "scene=gallery&map=lights&view=0.4/0.1/0.8",
    "scene=turntable&format=fx32&effects=shadow&map=tiles&at=0.7/0.3",
];

/// Scripts for browsers whose workers do not start.
const NO_WORKERS: [&str; 2] = [
    "window.Worker = undefined",
    "window.Worker = class extends Worker { constructor() { super('/no-such-script.js', { type: 'module' }) } }",
];

/// Upper bound of the processor time of a task of the page's main thread, in milliseconds.
const LONGEST: f64 = 50.0;

/// Attempts to see no longer task: a processor that others share, too, loses some of its speed.
const ATTEMPTS: usize = 3;

/// Sums of the picture, of its map and of its account.
const SUMS: &str = "(() => {
    const sum = (codes) => codes.reduce((sum, code) => (31 * sum + code) % 4294967291, 7);
    const map = document.getElementById('map');
    const { data } = map.getContext('2d').getImageData(0, 0, map.width, map.height);
    return [sum(luminaire.pixels()), map.hidden || sum(data), JSON.stringify(luminaire.account)].join();
})()";

pub(crate) fn draw_the_same_bits(visitor: &mut Visitor) -> Result<()> {
    for picture in PICTURES {
        let mut first = None;
        for workers in [0, 1, 2, 4] {
            let query = format!("?width=320&height=200&workers={workers}#stage?play=none&{picture}");
            let mut page = visitor.ready_at(&query)?;
            let found = sums_of_changes(&mut page)?;
            page.must_be_content().with_context(|| query.clone())?;
            let expected = first.get_or_insert_with(|| found.clone());
            ensure!(found == *expected, "{query}: expected {expected:?}, found {found:?}");
        }
    }
    Ok(())
}

/// The sums of a picture, and of the pictures after some changes.
fn sums_of_changes(page: &mut Page) -> Result<Vec<String>> {
    let mut sums = vec![page.text(SUMS)?];
    for id in ["light-1-on", "effect-specular", "light-1-on"] {
        page.ask(&format!("document.getElementById('{id}').click()"))?;
        page.settle()?;
        sums.push(page.text(SUMS)?);
    }
    Ok(sums)
}

/// Without workers the page draws by itself.
pub(crate) fn need_not_start(visitor: &mut Visitor) -> Result<()> {
    let query = "?width=320&height=200#stage?play=none&scene=three-point";
    let expected = visitor.ready_at(query)?.text(SUMS)?;
    for script in NO_WORKERS {
        let mut page = visitor.ready_with(query, script)?;
        let found = page.text(SUMS)?;
        ensure!(found == expected, "{script}: expected {expected}, found {found}");
        page.change("a beam, without workers", |page| page.enter("light-beam-number", 12))?;
        ensure!(!page.shows("failure")? && !page.shows("trouble")?, "{script} is told as a failure");
        page.ask("probe.until(() => probe.visible('scene-show'))")?;
    }
    Ok(())
}

/// No task of the page takes longer than 50 ms after it has loaded: not while the show plays, nor
/// while a slider is dragged.
pub(crate) fn leave_the_page_free(visitor: &mut Visitor) -> Result<()> {
    is_free(visitor, "", |page| {
        let drawn = page.number("luminaire.drawn")?;
        page.ask(&format!("probe.until(() => luminaire.drawn > {drawn} + 20)"))?;
        drag(page, "light-beam", 0.3)
    })
}

/// The same in the other views.
pub(crate) fn leave_every_view_free(visitor: &mut Visitor) -> Result<()> {
    is_free(visitor, "#compare?left=fx16&half=10", |page| drag(page, "half-angle", 0.8))?;
    is_free(visitor, "#museum", |page| drag(page, "exhibit-value", 0.1))?;
    is_free(visitor, "#chip", |page| page.ask("probe.until(() => luminaire.chip?.drawn > 1)").map(drop))
}

/// Drags a slider from a value on.
fn drag(page: &mut Page, slider: &str, from: f64) -> Result<()> {
    let drawn = page.number("luminaire.drawn")?;
    page.ask(&format!(
        "(async () => {{
            for (let i = 0; i < 20; i += 1) {{
                probe.enter('{slider}', {from} + 0.02 * i);
                await new Promise((resolve) => setTimeout(resolve, 20));
            }}
            await probe.until(() => luminaire.drawn > {drawn} + 3);
        }})()"
    ))
    .map(drop)
}

/// Fails if a task of a view takes too long while a visitor acts.
fn is_free(visitor: &mut Visitor, view: &str, act: impl Fn(&mut Page) -> Result<()>) -> Result<()> {
    let mut least = f64::INFINITY;
    for _ in 0..ATTEMPTS {
        let mut page = visitor.browser.open(&format!("{}{view}", visitor.address), "")?;
        page.ready()?;
        let tasks = page.tasks(&act)?;
        ensure!(tasks.len() > 20, "{view}: only {} tasks are recorded", tasks.len());
        least = least.min(tasks.iter().copied().fold(0.0, f64::max));
        page.must_be_content()?;
        if least <= LONGEST {
            return Ok(());
        }
    }
    anyhow::bail!("{view}: a task takes {least} ms of the processor, expected at most {LONGEST} ms")
}

/// Drawing needs no more memory from picture to picture.
pub(crate) fn keep_to_their_memory(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?play=none&scene=pocket")?;
    let found =
        page.ask("luminaire.measureMemory('show', 60, { width: 320, height: 180, with: ['shadow'] })")?;
    ensure!(found["before"].as_f64() > Some(1e6), "no memory is measured: {found}");
    ensure!(found["before"] == found["after"], "memory grows: {found}");
    page.must_be_content()
}
