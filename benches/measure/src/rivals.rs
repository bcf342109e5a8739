//! `cargo xtask rivals`: frames of the demo beside those of three.js, which draws the same scene
//! without a GPU.
//!
//! three.js draws by WebGL, which a browser without a GPU runs on the processor: Chromium by
//! SwiftShader, or by Mesa's llvmpipe. Both renderers draw the same triangles under the same lights, at
//! the same size, with one sample a pixel. The demo also anti-aliases the edges of meshes; three.js has
//! Phong's model and its default filter of shadows. The times depend on the machine, so only ratios of one run are worth quoting.

mod scene;

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use serde::Deserialize;
use tools::browser::{Visit, WebGl};
use tools::demo::site::{self, Build};
use tools::progress::Progress;
use tools::server::Server;
use tools::turntable::{Frame, LOADS, Load};
use tools::{install, project};

/// The files of the package that the page imports.
const LIBRARY: [&str; 2] = ["three.module.js", "three.core.js"];

const PAGE: [(&str, &str); 2] =
    [("index.html", include_str!("rivals/page.html")), ("rival.js", include_str!("rivals/rival.js"))];

/// The answer of the page of three.js. Times are medians in milliseconds.
#[derive(Deserialize)]
struct Answer {
    renderer: String,
    triangles: f64,
    lit: f64,
    #[serde(rename = "atRest")]
    at_rest: f64,
    moving: f64,
}

/// Times each load in three renderers, and prints a table.
pub fn run() -> Result<()> {
    let progress = Progress::Live;
    let (demo, folder) = (site::build(Build::Small, &progress)?, gather(&progress)?);
    let demo = Server::start(&demo)?;
    let rival = Server::start(&folder)?;
    let ours = ours(&demo, &progress)?;
    let mut columns = Vec::new();
    for web_gl in [WebGl::SwiftShader, WebGl::Llvmpipe] {
        columns.push(theirs(web_gl, &rival, &progress)?);
    }
    println!(
        "Milliseconds a frame of 960 x 540, camera at rest / moving, in f32; times the demo's in parentheses."
    );
    for answers in &columns {
        println!("three.js on {}", answers[0].renderer);
    }
    println!("| load | demo | three.js on SwiftShader | three.js on llvmpipe |");
    println!("|---|---|---|---|");
    for (number, (load, ours)) in LOADS.iter().zip(&ours).enumerate() {
        let theirs = columns.iter().map(|answers| {
            let Answer { at_rest, moving, .. } = &answers[number];
            let [still, turning] = [at_rest / ours.0, moving / ours.1];
            format!("{at_rest:.1} / {moving:.1} ({still:.1} / {turning:.1})")
        });
        let theirs = theirs.collect::<Vec<_>>().join(" | ");
        println!("| {} | {:.1} / {:.1} | {theirs} |", load.name, ours.0, ours.1);
    }
    Ok(())
}

/// Puts the page, three.js and the scenes into one folder.
fn gather(progress: &Progress) -> Result<PathBuf> {
    let library = install::npm("three", progress)?;
    let folder = project::target().join("rivals");
    fs::create_dir_all(&folder)?;
    for name in LIBRARY {
        fs::copy(library.join("build").join(name), folder.join(name))
            .with_context(|| format!("three.js has no file {name}"))?;
    }
    for (name, text) in PAGE {
        fs::write(folder.join(name), text)?;
    }
    for load in &LOADS {
        fs::write(folder.join(file(load)), scene::of(load.spots, load.shadows)?.to_string())?;
    }
    Ok(folder)
}

/// The file of a load's scene.
fn file(load: &Load) -> String {
    format!("spots-{}-{}.json", load.spots, load.shadows)
}

/// The demo's median times in `f32`, as three.js draws: with the camera at rest, and moving.
fn ours(server: &Server, progress: &Progress) -> Result<Vec<(f64, f64)>> {
    let address = format!("{}#stage?scene=three-point&play=none&format=f32", server.address());
    let frames: Vec<_> = LOADS.iter().map(|load| load.frame_call(scene::FRAMES)).collect();
    let found = Visit { address: &address, ..Visit::default() }.run(&frames, progress)?;
    let time = |(load, found): (&Load, _)| match Frame::of(found) {
        Frame { at_rest: Some(at_rest), moving: Some(moving) } => Ok((at_rest, moving)),
        _ => anyhow::bail!("nothing moves under the load {}", load.name),
    };
    LOADS.iter().zip(&found.values).map(time).collect()
}

/// The times of three.js for each load.
fn theirs(web_gl: WebGl, server: &Server, progress: &Progress) -> Result<Vec<Answer>> {
    let (mut answers, address) = (Vec::new(), server.address());
    for load in &LOADS {
        let visit = Visit { address: &address, web_gl: Some(web_gl) };
        let answer = progress.timed("Timing", format_args!("three.js: {}", load.name), || {
            visit.ask(&format!("rival('{}')", file(load)), progress)
        })?;
        let answer: Answer = serde_json::from_value(answer).context("three.js gave no times")?;
        ensure!(answer.lit > 0.5, "three.js lit only {} of the picture", answer.lit);
        progress.say("Drawn", format_args!("{} triangles", answer.triangles));
        answers.push(answer);
    }
    Ok(answers)
}
