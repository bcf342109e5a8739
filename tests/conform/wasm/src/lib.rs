//! Checks the conformance vectors in a browser.

use luminaire_conform::Check;
use wasm_bindgen::prelude::wasm_bindgen;

/// Checks the file. Returns the first cases that differ, each on a line of its own, then the number
/// of cases and how many of them differ.
#[wasm_bindgen]
pub fn check(file: &str) -> String {
    let (mut check, mut report) = (Check::default(), String::new());
    for line in file.lines() {
        // Writing to a string does not fail.
        let _ = check.take(line, &mut report);
    }
    format!("{report}{check}")
}
