//! The demo's module that the first picture needs: the stage and the painters of pictures in `f32`.

pub use wasm_demo::*;
