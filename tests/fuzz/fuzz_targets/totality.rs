//! Every light on every surface has an answer.
#![no_main]

#[path = "../../laws/mod.rs"]
mod laws;

use libfuzzer_sys::fuzz_target;
use luminaire_fuzz::{Law, hold};

const LAWS: [Law; 3] = [laws::spotlights_answer, laws::distances_answer, laws::highlights_answer];

fuzz_target!(|bytes: &[u8]| hold(&LAWS, bytes));
