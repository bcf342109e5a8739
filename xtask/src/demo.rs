//! `cargo demo`: the demo for a visitor, or for a check.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::arguments::{DemoOptions, Size};
use crate::browser::Chromium;
use crate::progress::Progress;
use crate::server::{self, Server};
use crate::site;

const PORT: u16 = 8080;

/// The median of so many frames is what the check reports.
const FRAMES: u32 = 15;

/// Builds the demo, then serves or checks it.
pub(crate) fn run(options: &DemoOptions) -> Result<()> {
    let progress = Progress::Live;
    let checking = options.check || options.screenshot.is_some();
    // Before the build, for who comes to a taken port should not wait to hear of it.
    let listener = server::listen(options.port.unwrap_or(if checking { 0 } else { PORT }))?;
    let server = Server::start(listener, &site::build(&progress)?)?;
    let address = address(&server, options);
    if checking {
        let step = progress.begin("Checking", &address);
        let mut chromium = Chromium::start(&progress)?;
        let verdict = check(&mut chromium, &address, options.screenshot.as_deref())?;
        drop(chromium);
        step.done();
        println!("{verdict}");
        Ok(())
    } else {
        println!("The demo is at {address} (Ctrl+C ends it)");
        server.wait()
    }
}

/// Runs the page once; answers one line with what it measured.
pub(crate) fn check(chromium: &mut Chromium, address: &str, screenshot: Option<&Path>) -> Result<String> {
    let mut page = chromium.open(address, "")?;
    page.ready()?;
    let measured = page.ask(&format!("luminaire.measure({FRAMES})"))?;
    ensure!(page.lit_share()? > 0.0, "the page drew nothing: every pixel is black");
    ensure!(page.holds("luminaire.scenes?.isLit ?? true")?, "the scene is black at every pixel");
    let scene =
        page.ask(&format!("luminaire.scenes && luminaire.measureScene(luminaire.scenes.example, {FRAMES})"))?;
    page.must_be_content()?;
    if let Some(file) = screenshot {
        page.settle()?;
        page.ask("luminaire.comparison?.measured")?;
        fs::write(file, page.screenshot()?).with_context(|| format!("cannot write {}", file.display()))?;
    }
    let number = |name: &str| {
        let value = &measured[name];
        value.as_f64().with_context(|| format!("luminaire.measure() gives {value} as its {name}"))
    };
    let stage = format!(
        "demo ok: {}x{}, {} lights, {}, lighting {:.2} ms, frame {:.2} ms",
        number("width")?,
        number("height")?,
        number("lights")?,
        measured["format"].as_str().context("luminaire.measure() gives no format")?,
        number("lightingMs")?,
        number("frameMs")?,
    );
    Ok(if scene.is_null() { stage } else { format!("{stage}; {}", of_scene(&scene)) })
}

/// What a scene has cost, in words.
fn of_scene(measured: &Value) -> String {
    let of = |camera: &str| {
        let time = |pass: &str| measured[camera][pass].as_f64();
        match (time("lightingMs"), time("frameMs")) {
            (Some(lighting), Some(frame)) => format!("lighting {lighting:.2} ms, frame {frame:.2} ms"),
            _ => "nothing moves".to_owned(),
        }
    };
    let (at_rest, moving) = (of("cameraAtRest"), of("cameraMoving"));
    format!("{}: {at_rest}; with a moving camera {moving}", measured["scene"].as_str().unwrap_or("a scene"))
}

fn address(server: &Server, options: &DemoOptions) -> String {
    let query = options.size.map(|Size { width, height }| format!("?width={width}&height={height}"));
    let view = options.view.as_ref().map(|view| format!("#{view}"));
    server.address() + &query.unwrap_or_default() + &view.unwrap_or_default()
}
