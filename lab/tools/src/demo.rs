//! The browser demo: building its folder, and timing its frames.

mod chip;
mod chips;
mod licenses;
pub mod preview;
pub mod publish;
mod shrink;
pub mod site;
pub mod turntable;
