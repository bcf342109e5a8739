//! The demo's module of the comparison and the museum, loaded when one of them is opened.

pub use wasm_demo::*;
