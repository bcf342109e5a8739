//! What each example states of itself.

use luminaire_render::scenes::Example;

#[test]
fn as_many_lights_hang_as_the_summaries_say() {
    let counts: Vec<_> = Example::ALL.iter().map(|example| example.setup().unwrap().fixtures.len()).collect();
    assert_eq!(counts, [1, 1, 4, 3, 64, 8, 8, 11, 26]);
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

/// 64 circles of 10 degrees cover the same area as 8 of 26.5.
#[test]
fn the_grids_light_the_same_area() {
    let area = |example: Example| -> f64 {
        let spots = example.setup().unwrap().fixtures_at(0.0).unwrap();
        let circles = spots.iter().map(|fixture| {
            let luminaire::dynamic::AnyLight::Spot(spot) = fixture.light() else { panic!("{fixture:?}") };
            let versine = f64::from(spot.cone().outer_versine());
            let radius = f64::from(spot.position().y) * (versine * (2.0 - versine)).sqrt() / (1.0 - versine);
            std::f64::consts::PI * radius * radius
        });
        circles.sum()
    };
    let ratio = area(Example::WideGrid) / area(Example::Grid);
    assert!((0.999..1.0).contains(&ratio), "{ratio}, expected ratio in 0.999..1.0");
}
