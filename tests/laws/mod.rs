//! Laws that hold for every scene. Each law is a function that takes raw words, builds a scene from
//! them, and panics if the law is broken.
//!
//! The property tests and the fuzzer call the same functions. Words from which no scene can be
//! built, because a constructor refuses them, are skipped.
#![allow(dead_code, unused_imports, reason = "each program that has these laws calls its part of them")]
#![allow(missing_docs, reason = "tests are read, not published")]
#![allow(unreachable_pub, reason = "every program has these modules to itself")]

#[path = "../support/format.rs"]
pub mod format;
pub mod scene;
pub mod words;

pub mod design;
pub mod display;
pub mod entries;
pub mod haze;
pub mod linearity;
pub mod monotony;
pub mod reach;
pub mod symmetry;
pub mod totality;

pub use design::two_angles_come_back;
pub use entries::quick_entries_agree;
pub use haze::beams_that_are_not_met_are_dark;
use luminaire::{Fx16, Fx32};
pub use reach::quick_rows_have_the_light_of_their_points;

/// Runs laws that are generic over the format in all three formats.
macro_rules! in_every_format {
    ($($module:ident::$law:ident,)*) => {
        $(pub fn $law(words: &[u32]) {
            $module::$law::<f32>(words);
            $module::$law::<Fx32>(words);
            $module::$law::<Fx16>(words);
        })*
    };
}

in_every_format! {
    design::descriptions_are_taken_or_refused,
    entries::entries_agree,
    totality::spotlights_answer,
    totality::distances_answer,
    totality::highlights_answer,
    monotony::falloffs_fall,
    monotony::distances_fall,
    monotony::intensity_adds,
    symmetry::turned_scenes_are_the_same,
    linearity::twice_is_twice,
    linearity::order_does_not_matter,
    display::fitting_keeps_what_fits,
    reach::lit_spheres_are_reached,
    reach::rows_have_the_light_of_their_points,
}
