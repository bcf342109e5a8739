//! The demo's module that reads files of other tools, loaded when the first is dropped or picked.

pub use wasm_demo::*;
