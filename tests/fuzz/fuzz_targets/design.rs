//! Constructors take a description or say what they would take.
#![no_main]

#[path = "../../laws/mod.rs"]
mod laws;

use libfuzzer_sys::fuzz_target;
use luminaire_fuzz::{Law, hold};

const LAWS: [Law; 2] = [laws::descriptions_are_taken_or_refused, laws::two_angles_come_back];

fuzz_target!(|bytes: &[u8]| hold(&LAWS, bytes));
