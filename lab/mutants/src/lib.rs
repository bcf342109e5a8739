//! Mutation testing of the kernel: small changes of its source, each of which a test should notice.
//!
//! All mutants are in one build, each behind a choice at run time, so that a mutant costs the tests
//! that reach it and no compilation. `cargo xtask mutants` runs them.

mod find;
mod list;
mod macros;
mod rewrite;
mod run;
#[cfg(test)]
mod tests;
mod tree;

pub use find::Mutant;
pub use run::{Options, Summary, run};
