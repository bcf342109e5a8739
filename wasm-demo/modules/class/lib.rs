//! The demo's module of the class, loaded when the class is opened.

pub use wasm_demo::*;
