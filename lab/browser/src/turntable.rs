//! Timing whole frames in a browser, on the scene turntable under each of its loads.

use anyhow::{Context, Result};

use crate::Page;

/// The name of the scene.
pub const SCENE: &str = "turntable";

/// The lights above the turntable.
#[derive(Debug)]
pub struct Load {
    /// Its name in tables.
    pub name: &'static str,
    /// The number of spotlights.
    pub spots: usize,
    /// The side of their shadow maps in texels; 0 for none.
    pub shadows: u16,
}

/// The loads, from the least to the largest.
pub static LOADS: [Load; 3] = [
    Load { name: "8 spots", spots: 8, shadows: 0 },
    Load { name: "4 spots, shadow maps of 512", spots: 4, shadows: 512 },
    Load { name: "32 spots", spots: 32, shadows: 0 },
];

/// Median frame times in milliseconds; `None` where nothing was drawn.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// With a camera at rest.
    pub at_rest: Option<f64>,
    /// With a turning camera, so that the geometry is redrawn.
    pub moving: Option<f64>,
}

/// Pictures a second, drawn by workers.
#[derive(Clone, Copy, Debug)]
pub struct Cores {
    /// How many workers there are.
    pub workers: u64,
    /// Of the workers that share each picture.
    pub together: f64,
    /// Of as many workers in independent loops, which show nothing.
    pub apart: f64,
}

/// Rounds of both, of which the better counts.
const ROUNDS: u32 = 3;

impl Load {
    /// Counts pictures of the turntable under the load, with a moving camera.
    pub fn cores(&self, page: &mut Page, frames: u32) -> Result<Cores> {
        cores(page, SCENE, frames, &self.options())
    }

    /// Times frames of the turntable under the load.
    pub fn time(&self, page: &mut Page, frames: u32) -> Result<Frame> {
        frame(page, SCENE, frames, &self.options())
    }

    /// Arguments of the page's meter for this load.
    fn options(&self) -> String {
        let shadows = if self.shadows > 0 { self.shadows.to_string() } else { "undefined".to_owned() };
        format!("{{ spots: {}, shadows: {shadows} }}", self.spots)
    }
}

/// Counts pictures of any scene, with a moving camera. `options` are arguments of the page's meter.
pub fn cores(page: &mut Page, scene: &str, frames: u32, options: &str) -> Result<Cores> {
    let found = page.ask(&format!("luminaire.measureCores('{scene}', {frames}, {ROUNDS}, {options})"))?;
    let rate = |name: &str| found[name].as_f64().with_context(|| format!("no {name} in {found}"));
    Ok(Cores {
        workers: found["workers"].as_u64().context("no workers")?,
        together: rate("togetherPerSecond")?,
        apart: rate("apartPerSecond")?,
    })
}

/// Times frames of any scene. `options` are arguments of the page's meter.
pub fn frame(page: &mut Page, scene: &str, frames: u32, options: &str) -> Result<Frame> {
    let found = page.ask(&format!("luminaire.measureScene('{scene}', {frames}, {options})"))?;
    let time = |camera: &str| found[camera]["frameMs"].as_f64();
    Ok(Frame { at_rest: time("cameraAtRest"), moving: time("cameraMoving") })
}
