//! The times of the passes of a painter.

use wasm_bindgen::prelude::*;

/// The time of each pass in milliseconds, by the browser's clock.
#[wasm_bindgen]
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Times {
    /// Nothing if the geometry was kept.
    pub geometry: Option<f64>,
    /// Nothing if the painter has drawn no shadow map.
    pub shadows: Option<f64>,
    /// The lighting pass.
    pub lighting: f64,
    /// The encoding for the display.
    pub encode: f64,
}
