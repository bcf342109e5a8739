//! `luminaire pick`: the cheapest evaluation of a spotlight whose error is small enough for a
//! display. `luminaire export`: a spotlight as source of another language.
#![forbid(unsafe_code)]

mod arguments;
mod model;
mod show;
mod text;
mod words;

use std::fs;
use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use clap::Parser;
use luminaire_export::{ExportError, printable};
use luminaire_pick::{Refusal, Request, Scene};

use arguments::{Command, Export, Pick};

fn main() -> ExitCode {
    let (text, is_done) = match Command::parse() {
        Command::Pick(pick) => match answer(&pick) {
            Ok(text) => (text, true),
            Err(refusal) if pick.json => (format!("{}\n", serde_json::json!({ "refused": refusal })), false),
            Err(refusal) => return refuse(&refusal),
        },
        Command::Export(options) => match export(&options) {
            Ok(text) => (text, true),
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

/// Returns a light as source.
fn export(options: &Export) -> Result<String, ExportError> {
    luminaire_export::export(model::light(options)?, &options.name, options.to)
}

/// Returns the answer as text or JSON.
fn answer(pick: &Pick) -> Result<String, Refusal> {
    let request = Request::new(pick.chip, pick.display).tolerance(pick.tolerance());
    let json = |value: serde_json::Value| format!("{value:#}\n");
    let to_value = |error: serde_json::Error| unreachable!("answers are JSON: {error}");
    let Some(scene) = &pick.scene else {
        let answer = request.pick(&pick.light())?;
        return Ok(if pick.json {
            json(serde_json::to_value(&answer).unwrap_or_else(to_value))
        } else {
            text::answer(&answer)
        });
    };
    let scene = if scene == "show" { show::lights()? } else { read(scene)? };
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

fn read(file: &str) -> Result<Scene, Refusal> {
    let refused = |found: String| Refusal {
        parameter: "scene".to_owned(),
        value: printable(file),
        expected: format!("`show`, or a JSON file of lights: {}", printable(&found)),
    };
    let text = fs::read_to_string(file).map_err(|error| refused(error.to_string()))?;
    serde_json::from_str(&text).map_err(|error| refused(error.to_string()))
}
