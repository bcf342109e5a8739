//! Timing frames in a browser, with an effect and without it.

use std::collections::BTreeMap;

use anyhow::{Context, Result};
use luminaire::dynamic::Effect;
use serde::{Deserialize, Serialize};

use browser::turntable::{self, LOADS, Load};
use browser::{Act, Visit};
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
    let step = progress.begin("Timing", "frames in Chromium");
    let of_trial = |trial: &Trial| {
        trial.options.map(|options| turntable::frame_call(&format!("'{}'", trial.scene), FRAMES, options))
    };
    let trials = TRIALS.iter().flat_map(|trial| (0..ROUNDS).flat_map(|_| of_trial(trial)));
    let loads = LOADS.iter().flat_map(|load| (0..ROUNDS).map(|_| load.frame_call(FRAMES)));
    let acts: Vec<_> = trials.chain(loads).map(Act::Ask).collect();
    let found = Visit { address: &server.address(), ..Visit::default() }.run(&acts, progress)?;
    let times: Vec<_> = found.values.iter().map(turntable::Frame::of).collect();
    let (trials, loads) = times.split_at(2 * ROUNDS * TRIALS.len());
    let trials = TRIALS.iter().zip(trials.chunks(2 * ROUNDS));
    let frames = trials.map(|(trial, times)| Ok((trial.effect.name().to_owned(), best(trial, times)?)));
    let frames = frames.collect::<Result<_>>()?;
    let loads = LOADS.iter().zip(loads.chunks(ROUNDS));
    let loads = loads.map(|(load, times)| Ok((load.name.to_owned(), whole(load, times)?)));
    let loads = loads.collect::<Result<_>>()?;
    step.done();
    Ok(Browser { runs_on: found.version, frames, loads })
}

/// The times with the effect and without it, while the lights move and the camera is at rest. Both come
/// from the same round, so that a slow machine affects both alike.
fn best(trial: &Trial, times: &[turntable::Frame]) -> Result<Frame> {
    let time = |frame: &turntable::Frame| {
        frame.at_rest.with_context(|| format!("the page has no time of {}", trial.scene))
    };
    let mut best = [f64::INFINITY; 2];
    for [with, without] in times.as_chunks::<2>().0 {
        let round = [time(with)?, time(without)?];
        if round.iter().sum::<f64>() < best.iter().sum::<f64>() {
            best = round;
        }
    }
    let [with_ms, without_ms] = best.map(hundredths);
    Ok(Frame { scene: trial.scene.to_owned(), with_ms, without_ms })
}

/// The times of the turntable under a load, each camera in its quickest round.
fn whole(load: &Load, times: &[turntable::Frame]) -> Result<Whole> {
    let mut best = [f64::INFINITY; 2];
    for turntable::Frame { at_rest, moving } in times {
        for (best, time) in best.iter_mut().zip([at_rest, moving]) {
            *best = best.min(time.with_context(|| format!("{} has no frame", load.name))?);
        }
    }
    let [at_rest_ms, moving_ms] = best.map(hundredths);
    Ok(Whole { at_rest_ms, moving_ms })
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
