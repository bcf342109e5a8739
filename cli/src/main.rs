//! `luminaire pick`: the cheapest evaluation of a spotlight whose error is small enough for a
//! display. `luminaire export`: a spotlight as source of another language.
#![forbid(unsafe_code)]

mod arguments;
mod model;
mod show;
mod text;

use std::fs;
use std::process::ExitCode;

use clap::Parser;
use luminaire_export::ExportError;
use luminaire_pick::{Refusal, Request, Scene};

use arguments::{Command, Export, Pick};

fn main() -> ExitCode {
    let pick = match Command::parse() {
        Command::Pick(pick) => pick,
        Command::Export(options) => return export(&options),
    };
    match answer(&pick) {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(refusal) => {
            if pick.json {
                println!("{}", serde_json::json!({ "refused": refusal }));
            } else {
                eprintln!("error: {refusal}");
            }
            ExitCode::FAILURE
        }
    }
}

/// Writes a light as source, or the reason why not.
fn export(options: &Export) -> ExitCode {
    let source = || -> Result<String, ExportError> {
        if options.header {
            return Ok(luminaire_export::c_header());
        }
        luminaire_export::export(model::light(options)?, &options.name, options.to)
    };
    match source() {
        Ok(source) => {
            print!("{source}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
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
        value: file.to_owned(),
        expected: format!("`show`, or a JSON file of lights: {found}"),
    };
    let text = fs::read_to_string(file).map_err(|error| refused(error.to_string()))?;
    serde_json::from_str(&text).map_err(|error| refused(error.to_string()))
}
