//! Timing frames in a browser, with an effect and without it.

use std::collections::BTreeMap;

use anyhow::{Context, Result};
use luminaire::dynamic::Effect;
use serde::{Deserialize, Serialize};

use browser::turntable::{self, LOADS, Load};
use browser::{Browser as _, Chromium, Page};
use tools::demo::site::{self, Build};
use tools::progress::Progress;
use tools::server::{self, Server};

/// Times in a browser. They are recorded only: no check compares them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Browser {
    pub(super) runs_on: String,
    /// Times of a frame with and without an effect, by the name of the effect.
    pub(super) frames: BTreeMap<String, Frame>,
    /// Times of the turntable, by the name of its load.
    pub(super) loads: BTreeMap<String, Whole>,
}

/// What a whole frame takes, in milliseconds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Whole {
    pub(super) at_rest_ms: f64,
    pub(super) moving_ms: f64,
}

/// What a frame of a scene takes with an effect and without it, in milliseconds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Frame {
    pub(super) scene: String,
    pub(super) with_ms: f64,
    pub(super) without_ms: f64,
}

/// A scene that is timed with an effect and without it.
struct Trial {
    effect: Effect,
    scene: &'static str,
    /// Arguments of the page's meter, with the effect and without it.
    options: [&'static str; 2],
}

static TRIALS: [Trial; 5] = [
    Trial { effect: Effect::Specular, scene: "turntable", options: ["{}", "{ without: ['specular'] }"] },
    Trial { effect: Effect::Gobo, scene: "show", options: ["{}", "{ without: ['gobo'] }"] },
    Trial { effect: Effect::Shadow, scene: "turntable", options: ["{ with: ['shadow'] }", "{}"] },
    Trial { effect: Effect::Haze, scene: "turntable", options: ["{ with: ['haze'] }", "{}"] },
    Trial { effect: Effect::Dither, scene: "turntable", options: ["{ with: ['dither'] }", "{}"] },
];

/// Each time is the median of `FRAMES` frames in the quickest of `ROUNDS` rounds, because other
/// work of the machine seldom disturbs all rounds.
const FRAMES: u32 = 15;
const ROUNDS: usize = 3;

/// Times a frame with and without every effect that has a switch, and the turntable under each
/// load.
pub(super) fn time(progress: &Progress) -> Result<Browser> {
    let server = Server::start(server::listen(0)?, &site::build(Build::Small, progress)?)?;
    let mut chromium = Chromium::start(progress)?;
    let runs_on = chromium.version()?;
    let step = progress.begin("Timing", format_args!("frames in {runs_on}"));
    let mut page = chromium.open(&server.address(), "")?;
    page.ready()?;
    let mut frames = BTreeMap::new();
    for trial in &TRIALS {
        let mut best = [f64::INFINITY; 2];
        for _ in 0..ROUNDS {
            let [with, without] = trial.options.map(|options| frame(&mut page, trial.scene, options));
            let round = [with?, without?];
            // Both times come from the same round, so that a slow machine affects both alike.
            if round.iter().sum::<f64>() < best.iter().sum::<f64>() {
                best = round;
            }
        }
        let [with_ms, without_ms] = best.map(hundredths);
        let frame = Frame { scene: trial.scene.to_owned(), with_ms, without_ms };
        frames.insert(trial.effect.name().to_owned(), frame);
    }
    let loads = LOADS.iter().map(|load| Ok((load.name.to_owned(), whole(&mut page, load)?)));
    let loads = loads.collect::<Result<_>>()?;
    page.must_be_content()?;
    step.done();
    Ok(Browser { runs_on, frames, loads })
}

/// Times the turntable under a load, each camera in its quickest round.
fn whole(page: &mut Page, load: &Load) -> Result<Whole> {
    let mut best = [f64::INFINITY; 2];
    for _ in 0..ROUNDS {
        let turntable::Frame { at_rest, moving } = load.time(page, FRAMES)?;
        let round = [at_rest, moving].map(|time| time.with_context(|| format!("{} has no frame", load.name)));
        for (best, time) in best.iter_mut().zip(round) {
            *best = best.min(time?);
        }
    }
    let [at_rest_ms, moving_ms] = best.map(hundredths);
    Ok(Whole { at_rest_ms, moving_ms })
}

/// A frame while the lights move and the camera is at rest.
fn frame(page: &mut Page, scene: &str, options: &str) -> Result<f64> {
    let time = turntable::frame(page, scene, FRAMES, options)?.at_rest;
    time.with_context(|| format!("the page has no time of {scene} with {options}"))
}

fn hundredths(value: f64) -> f64 {
    (value * 100.0).round() / 100.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_effect_is_there_in_one_picture_and_not_in_the_other() {
        for Trial { effect, options: [with, without], .. } in &TRIALS {
            let effect = effect.name();
            let puts_in = with.contains(&format!("with: ['{effect}']"));
            let leaves_out = without.contains(&format!("without: ['{effect}']"));
            assert!(puts_in != leaves_out, "{effect}");
        }
    }
}
