//! `luminaire pick`: the cheapest evaluation of a light whose error is small enough for a
//! display. `luminaire export`: lights as source of another language, or as the parameters of another
//! tool. `luminaire import`: the lights of files. `luminaire still`: a wall lit by a light. `luminaire leds`: a program
//! that lights a strip of LEDs at their places.
#![forbid(unsafe_code)]

mod arguments;
mod chart;
mod export;
mod import;
mod leds;
mod model;
mod show;
mod source;
mod still;
mod text;
mod words;

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use clap::Parser;
use luminaire_export::printable;
use luminaire_pick::{Farther, Light, Refusal, Request, Scene};
use serde_json::{Value, to_value};

use arguments::{Command, Pick};
use source::Found;

fn main() -> ExitCode {
    let command = match Command::try_parse() {
        Ok(command) => command,
        Err(error) => return explain(&error),
    };
    let told = match command {
        Command::Pick(pick) => match answer(&pick) {
            Err(refusal) if pick.json => Ok((json(&serde_json::json!({ "refused": refusal })), false)),
            Err(refusal) => return refuse(&refusal),
            Ok(answer) => Ok(answer),
        },
        Command::Export(options) => export::export(&options),
        Command::Import(options) => import::import(&options),
        Command::Leds(options) => leds::leds(&options).map(|is_whole| (String::new(), is_whole)),
        Command::Still(options) => still::still(&options).map(|is_whole| (String::new(), is_whole)),
    };
    let (text, is_whole) = match told {
        Ok(told) => told,
        Err(refusal) => return refuse(&refusal),
    };
    match io::stdout().write_all(text.as_bytes()).and_then(|()| io::stdout().flush()) {
        // A reader that has read enough closes its end.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => refuse(&format!("output: {error}")),
        _ if is_whole => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    }
}

/// Writes the help, the version or what is wrong with the options.
fn explain(error: &clap::Error) -> ExitCode {
    let text = error.to_string();
    let lines: String = text.lines().map(|line| printable(line) + "\n").collect();
    let _ = if error.use_stderr() {
        io::stderr().write_all(lines.as_bytes())
    } else {
        io::stdout().write_all(lines.as_bytes())
    };
    ExitCode::from(error.exit_code() as u8)
}

/// Writes why not.
fn refuse(reason: &dyn std::fmt::Display) -> ExitCode {
    text::say("error", reason);
    ExitCode::FAILURE
}

/// Returns an answer or a refusal as JSON. Names in answers are plain words; a refusal escapes what it is made of.
fn json(value: &Value) -> String {
    format!("{value:#}\n")
}

/// Returns the answer as text or JSON, and whether no light was refused.
fn answer(pick: &Pick) -> Result<(String, bool), Refusal> {
    let shown = |value: serde_json::Result<Value>, text| match value {
        Ok(value) if pick.json => json(&value),
        Ok(_) => text,
        Err(error) => unreachable!("answers are JSON: {error}"),
    };
    let request = Request::new(pick.chip, pick.display).tolerance(pick.tolerance());
    let request = if pick.worst { request.worst_case() } else { request };
    let (scene, is_whole) = match &pick.scene {
        Some(scene) if scene == "show" => {
            pick.source.say_idle(&pick.spot, false, &[]);
            (show::lights()?, true)
        }
        Some(scene) => lights(&source::Source { values: vec![scene.clone()], ..pick.source.clone() }, pick)?,
        None => lights(&pick.source, pick)?,
    };
    let text = match &scene.lights[..] {
        [] => String::new(),
        [light] if pick.scene.is_none() => {
            let answer = request.pick(light)?;
            let farther = request.farther(&answer)?;
            let text = text::answer(&answer, &farther);
            shown(to_value(&answer).map(|value| with(value, &farther)), text)
        }
        lights if pick.each => {
            let answers: Result<Vec<_>, _> = lights.iter().map(|light| request.pick(light)).collect();
            let answers = answers?;
            let farther: Result<Vec<_>, _> = answers.iter().map(|answer| request.farther(answer)).collect();
            let farther = farther?;
            let each = to_value(&answers).map(|value| with_each(value, &farther));
            shown(each, text::lights(&answers, &farther))
        }
        _ => {
            let answer = request.pick_scene(&scene)?;
            let farther = request.farther_in_scene(&answer)?;
            let value = to_value(&answer).map(|mut value| {
                value["lights"] = with_each(value["lights"].take(), &farther);
                value
            });
            shown(value, text::scene(&answer, &farther))
        }
    };
    Ok((text, is_whole))
}

/// Returns an answer with the evaluations that cost less farther away.
fn with(mut answer: Value, farther: &[Farther]) -> Value {
    answer["farther"] = to_value(farther).unwrap_or_default();
    answer
}

fn with_each(answers: Value, farther: &[Vec<Farther>]) -> Value {
    let Value::Array(answers) = answers else { return answers };
    answers.into_iter().zip(farther).map(|(answer, farther)| with(answer, farther)).collect()
}

/// Returns the lights of a source, or without one the light of the options.
fn lights(source: &source::Source, pick: &Pick) -> Result<(Scene, bool), Refusal> {
    let told = |refusal: luminaire_exchange::Refusal| Refusal {
        parameter: if refusal.place.is_empty() {
            refusal.parameter
        } else {
            format!("{}: {}", refusal.place, refusal.parameter)
        },
        value: refusal.value,
        expected: refusal.expected,
    };
    let Some(Found { lamps, is_whole, .. }) = source.load(&pick.spot, false).map_err(told)? else {
        if pick.has_idle_edge() {
            text::say("note", "--edge has no effect: --beam and --field together determine the falloff");
        }
        return Ok((Scene { lights: vec![pick.light()?] }, true));
    };
    let light = |(lamp, usage): &(luminaire_exchange::Lamp, luminaire_exchange::Use)| {
        let named = lamp.named(*usage).map_err(told)?;
        let light = Light::of(&named.name, &named.light);
        let Some([near, far]) = named.surfaces else { return pick.lit(light) };
        Ok(Light { near: pick.near.unwrap_or(near), far: pick.far.unwrap_or(far), ..light })
    };
    Ok((Scene { lights: lamps.iter().map(light).collect::<Result<_, Refusal>>()? }, is_whole))
}
