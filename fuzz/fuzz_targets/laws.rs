//! Light falls, adds, has no preferred direction, and is none where a beam is not met.
#![no_main]

#[path = "../../tests/properties/mod.rs"]
mod properties;

use libfuzzer_sys::fuzz_target;
use luminaire_fuzz::{Law, hold};

const LAWS: [Law; 9] = [
    properties::falloffs_fall,
    properties::distances_fall,
    properties::intensity_adds,
    properties::turned_scenes_are_the_same,
    properties::twice_is_twice,
    properties::order_does_not_matter,
    properties::codes_never_fall,
    properties::fitting_keeps_what_fits,
    properties::beams_that_are_not_met_are_dark,
];

fuzz_target!(|bytes: &[u8]| hold(&LAWS, bytes));
