//! What the project's commands run: other programs, compilers for every target, servers and a
//! browser; and how they report.

pub mod browser;
pub mod command;
pub mod demo;
mod http;
pub mod install;
pub mod progress;
pub mod project;
pub mod server;
pub mod suite;
pub mod tally;
pub mod toolchain;
pub mod wasm;
