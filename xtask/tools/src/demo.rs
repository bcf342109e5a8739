//! The browser demo: building its folder.

mod chip;
pub mod chips;
mod licenses;
pub mod publish;
mod shrink;
pub mod site;
