//! The pictures that the firmware of the boards shows, drawn in the browser by the same code, so
//! that the demo compares each pixel that an emulated display receives.

use luminaire_stage::{STAGES, Shown};
use wasm_bindgen::prelude::wasm_bindgen;

/// A picture of the sequence that the firmware shows.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Expected(Shown);

#[wasm_bindgen]
impl Expected {
    /// Draws the picture that the firmware shows after `number` others.
    #[wasm_bindgen(constructor)]
    pub fn new(number: u32) -> Self {
        Self(Shown::numbered(number))
    }

    /// The name in the line that the firmware prints.
    #[wasm_bindgen(getter)]
    pub fn name(&self) -> String {
        self.0.name.clone()
    }

    /// The first and the last column of the window, then its first and its last row.
    #[wasm_bindgen(getter)]
    pub fn window(&self) -> Vec<u16> {
        [self.0.columns, self.0.rows].concat()
    }

    /// RGB565, row by row.
    #[wasm_bindgen(getter)]
    pub fn pixels(&self) -> Vec<u16> {
        self.0.pixels.clone()
    }

    /// The checksum of the pixels.
    #[wasm_bindgen(getter)]
    pub fn checksum(&self) -> u32 {
        self.0.checksum()
    }
}

/// The names of the stages of a row, in the order in which the firmware marks them.
#[wasm_bindgen]
pub fn stages() -> Vec<String> {
    STAGES.split(' ').map(str::to_owned).collect()
}
