//! Timing whole frames in a browser, on the scene turntable under each of its loads.

use serde_json::{Value, json};

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

impl Load {
    /// Arguments of the page's meter for this load.
    pub fn options(&self) -> Value {
        let mut options = json!({ "spots": self.spots });
        if self.shadows > 0 {
            options["shadows"] = self.shadows.into();
        }
        options
    }

    /// The expression that times frames of the turntable under the load.
    pub fn frame_call(&self, frames: u32) -> String {
        frame_call(&format!("'{SCENE}'"), frames, &self.options().to_string())
    }
}

/// The expression that times frames of a scene. `options` are arguments of the page's meter.
pub fn frame_call(scene: &str, frames: u32, options: &str) -> String {
    format!("luminaire.measureScene({scene}, {frames}, {options})")
}

impl Frame {
    /// The value of the first expression.
    pub fn of(found: &Value) -> Self {
        let time = |camera: &str| found[camera]["frameMs"].as_f64();
        Self { at_rest: time("cameraAtRest"), moving: time("cameraMoving") }
    }
}
