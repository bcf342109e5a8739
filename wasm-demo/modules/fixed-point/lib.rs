//! The demo's module of pictures in fixed point, loaded with the first such picture.

pub use wasm_demo::*;
