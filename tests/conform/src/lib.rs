//! Conformance vectors: for every model of luminaire in every number format, inputs and outputs as
//! bits, in one file of text that is the same for every machine. The file alone is enough to test
//! another implementation of the kernel, in any language; the folder's README says how to read it.
//!
//! This library evaluates the file's lines one by one in a few hundred bytes of memory, so that it
//! also runs on a microcontroller. The program `conform` beside it writes the file and checks the
//! host.
#![no_std]
#![forbid(unsafe_code)]

mod case;
mod check;
mod model;
mod text;
mod word;

pub use case::{Case, Evaluate, Input, Inputs, Kind};
pub use check::Check;
pub use model::{Model, each_model};
pub use text::Text;
pub use word::{Format, Word};
