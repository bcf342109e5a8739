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

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use clap::Parser;
use luminaire_pick::{Light, Refusal, Request, Scene};
use serde_json::{Value, to_value};

use arguments::{Command, Pick};

fn main() -> ExitCode {
    let told = match Command::parse() {
        Command::Pick(pick) => match answer(&pick) {
            Err(refusal) if pick.json => {
                Ok((format!("{}\n", serde_json::json!({ "refused": refusal })), false))
            }
            Err(refusal) => return refuse(&refusal),
            Ok(text) => Ok((text, true)),
        },
        Command::Export(options) => export::export(&options).map(|text| (text, true)),
        Command::Import(options) => import::import(&options),
        Command::Still(options) => still::still(&options).map(|()| (String::new(), true)),
    };
    let (text, is_done) = match told {
        Ok(told) => told,
        Err(refusal) => return refuse(&refusal),
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

/// Returns the answer as text or JSON.
fn answer(pick: &Pick) -> Result<String, Refusal> {
    let shown = |value: serde_json::Result<Value>, text| match value {
        Ok(value) if pick.json => format!("{value:#}\n"),
        Ok(_) => text,
        Err(error) => unreachable!("answers are JSON: {error}"),
    };
    let request = Request::new(pick.chip, pick.display).tolerance(pick.tolerance());
    let scene = match &pick.scene {
        Some(scene) if scene == "show" => show::lights()?,
        Some(scene) => lights(&source::Source { from: Some(scene.clone()), ..pick.source.clone() }, pick)?,
        None => lights(&pick.source, pick)?,
    };
    if let (None, [light]) = (&pick.scene, &scene.lights[..]) {
        let answer = request.pick(light)?;
        return Ok(shown(to_value(&answer), text::answer(&answer)));
    }
    if pick.each {
        let answers: Result<Vec<_>, _> = scene.lights.iter().map(|light| request.pick(light)).collect();
        let answers = answers?;
        return Ok(shown(to_value(&answers), text::lights(&answers)));
    }
    let answer = request.pick_scene(&scene)?;
    Ok(shown(to_value(&answer), text::scene(&answer)))
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
