//! The demo's module of pictures in 32 bits, loaded with the first such picture.

pub use wasm_demo::*;
