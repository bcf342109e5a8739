//! The demo's module that writes lights as source, loaded when its drawer is opened.

pub use wasm_demo::*;
