//! The tools of the project's commands: running programs, compilers for every target, the demo's
//! build and a web server; and reporting progress.

pub mod board;
pub mod browser;
pub mod command;
pub mod compilers;
pub mod demo;
pub mod family;
pub mod install;
pub mod progress;
pub mod project;
pub mod record;
pub mod server;
pub mod suite;
pub mod system;
pub mod tally;
pub mod tool;
pub mod toolchain;
pub mod trouble;
pub mod turntable;
pub mod wasm;
