//! Every light on every surface has an answer.
#![no_main]

#[path = "../../tests/properties/mod.rs"]
mod properties;

use libfuzzer_sys::fuzz_target;
use luminaire_fuzz::{Law, hold};

const LAWS: [Law; 3] =
    [properties::spotlights_answer, properties::distances_answer, properties::highlights_answer];

fuzz_target!(|bytes: &[u8]| hold(&LAWS, bytes));
