//! What each example states of itself.

use luminaire_render::scenes::Example;

#[test]
fn as_many_lights_hang_as_the_summaries_say() {
    let counts: Vec<_> = Example::ALL.iter().map(|example| example.setup().unwrap().fixtures.len()).collect();
    assert_eq!(counts, [1, 1, 4, 3, 64, 8, 11, 26]);
}

#[test]
fn the_seconds_alone_say_what_has_moved() {
    for &example in Example::ALL {
        let setup = example.setup().unwrap();
        assert_eq!(setup, example.setup().unwrap());
        for seconds in [-3.0, 0.0, 0.1, 1e6, 1e30] {
            let fixtures = setup.fixtures_at(seconds).unwrap();
            assert_eq!(fixtures, setup.fixtures_at(seconds).unwrap());
            assert_eq!(fixtures.len(), setup.fixtures.len());
        }
        let moves = setup.fixtures_at(0.0).unwrap() != setup.fixtures_at(2.6).unwrap();
        let stands_still = matches!(example, Example::BareSpot | Example::Pocket | Example::ThreePoint);
        assert_eq!(moves, !stands_still, "{}", example.name());
    }
}
