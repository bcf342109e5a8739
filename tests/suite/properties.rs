//! The laws that hold for every scene, on random words. They run on stable Rust, on fewer scenes
//! than the fuzzer tries.

use crate::laws;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// Number of scenes that each law is tested on: 1,500, or 50,000 if `LUMINAIRE_FULL` is set.
fn cases() -> u32 {
    if std::env::var_os("LUMINAIRE_FULL").is_some() { 50_000 } else { 1_500 }
}

/// A word of any bits, or one of the bit patterns that have broken arithmetic before.
fn word() -> impl Strategy<Value = u32> {
    const SEAMS: [u32; 12] = [
        0,
        1,
        0x007f_ffff,
        0x0080_0000,
        0x3f80_0000,
        0x7f7f_ffff,
        0x7f80_0000,
        0x7fc0_0000,
        0x7fff_ffff,
        0x8000_0000,
        0xff80_0000,
        0xffff_ffff,
    ];
    prop_oneof![7 => any::<u32>(), 1 => proptest::sample::select(&SEAMS[..])]
}

fn hold(law: fn(&[u32])) {
    let config =
        Config { cases: cases(), failure_persistence: None, max_shrink_iters: 500, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    // Half of the scenes consist only of numbers of everyday size. Otherwise hardly any scene would
    // be lit.
    let words = (any::<bool>(), proptest::collection::vec(word(), 64));
    let outcome = runner.run(&words, |(tame, mut words)| {
        words[0] = if tame { 0 } else { words[0] };
        law(&words);
        Ok(())
    });
    if let Err(error) = outcome {
        panic!("{error}");
    }
}

/// A test for each law.
macro_rules! hold {
    ($($law:ident,)*) => {
        $(#[test]
        fn $law() {
            hold(laws::$law);
        })*
    };
}

hold! {
    entries_agree,
    quick_entries_agree,
    spotlights_answer,
    distances_answer,
    highlights_answer,
    descriptions_are_taken_or_refused,
    two_angles_come_back,
    falloffs_fall,
    distances_fall,
    intensity_adds,
    turned_scenes_are_the_same,
    twice_is_twice,
    order_does_not_matter,
    fitting_keeps_what_fits,
    beams_that_are_not_met_are_dark,
    lit_spheres_are_reached,
    rows_have_the_light_of_their_points,
    quick_rows_have_the_light_of_their_points,
}
