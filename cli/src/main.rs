//! `luminaire pick`: the cheapest evaluation of a spotlight whose error is small enough for a
//! display. `luminaire export`: lights as source of another language, or as the parameters of another
//! tool. `luminaire import`: the lights of files. `luminaire still`: a wall lit by a light.
#![forbid(unsafe_code)]

mod arguments;
mod chart;
mod export;
mod import;
mod model;
mod show;
mod source;
mod still;
mod text;
mod words;

use std::fs;
use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use clap::Parser;
use luminaire_pick::{Light, Refusal, Request, Scene};

use arguments::{Command, Pick, Still};

fn main() -> ExitCode {
    let (text, is_done) = match Command::parse() {
        Command::Pick(pick) => match answer(&pick) {
            Ok(text) => (text, true),
            Err(refusal) if pick.json => (format!("{}\n", serde_json::json!({ "refused": refusal })), false),
            Err(refusal) => return refuse(&refusal),
        },
        Command::Export(options) => match export::export(&options) {
            Ok(text) => (text, true),
            Err(error) => return refuse(&error),
        },
        Command::Import(options) => match import::import(&options) {
            Ok(told) => told,
            Err(error) => return refuse(&error),
        },
        Command::Still(options) => match still(&options) {
            Ok(()) => (String::new(), true),
            Err(error) => return refuse(&error),
        },
    };
    match io::stdout().write_all(text.as_bytes()).and_then(|()| io::stdout().flush()) {
        // A reader that has read enough closes its end.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => refuse(&format!("output: {error}")),
        _ if is_done => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    }
}

/// Writes why not. Nothing can be done if that fails.
fn refuse(reason: &dyn std::fmt::Display) -> ExitCode {
    let _ = writeln!(io::stderr(), "error: {reason}");
    ExitCode::FAILURE
}

/// Writes the picture of a light.
fn still(options: &Still) -> Result<(), luminaire_exchange::Refusal> {
    let refused = |expected: String| luminaire_exchange::Refusal::new("light", "none", expected);
    let loaded = options.source.load(&options.spot)?;
    let loaded = loaded
        .ok_or_else(|| refused("--from, --fixture, or angles with --lumens or --candela".to_owned()))?;
    let lamp = match &loaded.lamps.lamps[..] {
        [lamp] => lamp,
        lamps => return Err(refused(format!("--light with a number from 1 to {}", lamps.len()))),
    };
    let light = lamp.named(loaded.usage)?.light;
    let picture = still::png(&still::wall(&light, loaded.usage.throw)?)?;
    let written = fs::write(&options.output, picture);
    written.map_err(|error| luminaire_exchange::Refusal::new("output", &options.output, error))
}

/// Returns the answer as text or JSON.
fn answer(pick: &Pick) -> Result<String, Refusal> {
    let request = Request::new(pick.chip, pick.display).tolerance(pick.tolerance());
    let json = |value: serde_json::Value| format!("{value:#}\n");
    let to_value = |error: serde_json::Error| unreachable!("answers are JSON: {error}");
    let scene = match &pick.scene {
        Some(scene) if scene == "show" => show::lights()?,
        Some(scene) => lights(&source::Source { from: Some(scene.clone()), ..pick.source.clone() }, pick)?,
        None => match &lights(&pick.source, pick)?.lights[..] {
            [light] => {
                let answer = request.pick(light)?;
                return Ok(if pick.json {
                    json(serde_json::to_value(&answer).unwrap_or_else(to_value))
                } else {
                    text::answer(&answer)
                });
            }
            lights => Scene { lights: lights.to_vec() },
        },
    };
    if pick.each {
        let answers: Result<Vec<_>, _> = scene.lights.iter().map(|light| request.pick(light)).collect();
        let answers = answers?;
        return Ok(if pick.json {
            json(serde_json::to_value(&answers).unwrap_or_else(to_value))
        } else {
            text::lights(&answers)
        });
    }
    let answer = request.pick_scene(&scene)?;
    Ok(if pick.json {
        json(serde_json::to_value(&answer).unwrap_or_else(to_value))
    } else {
        text::scene(&answer)
    })
}

/// Returns the lights of a source, or without one the light of the options.
fn lights(source: &source::Source, pick: &Pick) -> Result<Scene, Refusal> {
    let told = |refusal: luminaire_exchange::Refusal| Refusal {
        parameter: if refusal.place.is_empty() {
            refusal.parameter
        } else {
            format!("{}: {}", refusal.place, refusal.parameter)
        },
        value: refusal.value,
        expected: refusal.expected,
    };
    let Some(loaded) = source.load(&pick.spot).map_err(told)? else {
        return Ok(Scene { lights: vec![pick.light()] });
    };
    let light = |lamp: &luminaire_exchange::Lamp| {
        let named = lamp.named(loaded.usage).map_err(told)?;
        let light = Light::of(&named.name, &named.light)?;
        let [near, far] = named.surfaces.unwrap_or([light.near, light.far]);
        Ok(Light { near: pick.near.unwrap_or(near), far: pick.far.unwrap_or(far), ..light })
    };
    Ok(Scene { lights: loaded.lamps.lamps.iter().map(light).collect::<Result<_, Refusal>>()? })
}
