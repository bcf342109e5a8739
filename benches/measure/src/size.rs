//! What linked programs prove: no panic, no heap, and not a byte for effects that are not used.

pub(crate) mod effects;
pub mod program;
mod proof;
mod public;
pub mod steps;
