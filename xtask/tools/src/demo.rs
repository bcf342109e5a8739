//! The browser demo: building its folder.

mod chip;
mod chips;
mod licenses;
pub mod publish;
mod shrink;
pub mod site;
