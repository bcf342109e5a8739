//! Light falls, adds, has no preferred direction, and is none where a beam is not met or a sphere
//! not reached.
#![no_main]

#[path = "../../laws/mod.rs"]
mod laws;

use libfuzzer_sys::fuzz_target;
use luminaire_fuzz::{Law, hold};

const LAWS: [Law; 13] = [
    laws::entries_agree,
    laws::quick_entries_agree,
    laws::falloffs_fall,
    laws::distances_fall,
    laws::intensity_adds,
    laws::turned_scenes_are_the_same,
    laws::twice_is_twice,
    laws::order_does_not_matter,
    laws::fitting_keeps_what_fits,
    laws::beams_that_are_not_met_are_dark,
    laws::lit_spheres_are_reached,
    laws::rows_have_the_light_of_their_points,
    laws::quick_rows_have_the_light_of_their_points,
];

fuzz_target!(|bytes: &[u8]| hold(&LAWS, bytes));
