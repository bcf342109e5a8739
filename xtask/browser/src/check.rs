//! The check of the demo in a browser: `cargo demo --check` and `--screenshot`.

use std::path::Path;

use anyhow::{Context, Result, ensure};
use serde_json::{Value, json};
use tools::progress::Progress;

use crate::turntable::{self, Cores, Frame, LOADS, Load};
use crate::{Act, Visit};

/// Number of frames that the check draws. It reports their median time.
const FRAMES: u32 = 15;

/// Records when the page is ready to be used, which is when it shows its first picture.
const READY: &str = "document.addEventListener('DOMContentLoaded', () => {
    new MutationObserver(() => {
        if (document.body.dataset.state === 'ready') window.readyAfter ??= performance.now();
    }).observe(document.body, { attributes: true });
})";

/// The time until then, the scene, and whether a picture that is shown has a pixel that is not black.
const FIRST: &str = "[readyAfter, luminaire.scene, !document.getElementById('view').checkVisibility() ||
    luminaire.pixels().some((code, i) => i % 4 < 3 && code > 0)]";

/// Time for the small pictures of the scenes, and for times of more than one picture.
const PAUSE: &str = "(async () => {
    await new Promise((resolve) => setTimeout(resolve, 3000));
    await luminaire.comparison?.measured;
})()";

/// A picture that plays would take the workers' time.
const STOP: &str = "['play', 'camera'].forEach((id) => {
    const box = document.getElementById(id);
    if (box.checked) box.click();
})";

/// Runs the page once, and writes a picture of it. Returns its measurements as one line.
pub fn check(address: &str, screenshot: Option<&Path>, progress: &Progress) -> Result<String> {
    let mut acts = vec![Act::Ask(FIRST.to_owned())];
    if let Some(file) = screenshot {
        acts.extend([Act::Ask(PAUSE.to_owned()), Act::Picture(file.to_owned())]);
    }
    // The turntable is timed under each of its loads, and another scene as it is.
    let loads: Vec<Value> = LOADS.iter().map(Load::options).collect();
    let times = format!(
        "(async () => {{
            {STOP};
            const {{ scene }} = luminaire;
            const times = [];
            for (const load of scene === '{}' ? {} : [{{}}]) {{
                times.push(await {}, await {});
            }}
            return times;
        }})()",
        turntable::SCENE,
        json!(loads),
        turntable::frame_call("scene", FRAMES, "load"),
        turntable::cores_call("scene", FRAMES, "load"),
    );
    acts.push(Act::Ask(times));
    let found = Visit { address, script: READY, ..Visit::default() }.run(&acts, progress)?.values;
    let (first, times) = (&found[0], found.last().and_then(Value::as_array).context("no times")?);
    let ready = first[0].as_f64().context("the page is never ready")?;
    let scene = first[1].as_str().context("the page has no scene")?;
    ensure!(first[2] == true, "the page drew nothing: every pixel is black");
    let mut told = times.as_chunks::<2>().0.iter().map(|[frame, cores]| {
        Ok(format!("{}{}", in_words(Frame::of(frame)), cores_in_words(Cores::of(cores)?)))
    });
    let told = if scene == turntable::SCENE {
        let told = LOADS
            .iter()
            .zip(told)
            .map(|(load, told): (_, Result<_>)| Ok(format!("{}: {}", load.name, told?)));
        told.collect::<Result<Vec<_>>>()?.join("; ")
    } else {
        told.next().context("no times")??
    };
    Ok(format!("demo ok: the first picture after {ready:.0} ms; {scene}: {told}"))
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
