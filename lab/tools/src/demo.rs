//! The browser demo: building its folder.

mod chip;
mod chips;
mod licenses;
pub mod preview;
pub mod publish;
mod shrink;
pub mod site;
