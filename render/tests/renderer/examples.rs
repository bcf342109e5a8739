//! The effects that each example needs.

use luminaire_render::scenes::Example;

/// The effects of each example at any time, with the names of the price list.
const CALLED_FOR: [(Example, &str); 9] = [
    (Example::BareSpot, "diffuse, spot, soft, inverse-square"),
    (Example::Pocket, "diffuse, spot, soft, inverse-square, dither"),
    (Example::Tree, "ambient, diffuse, spot, soft, unattenuated"),
    (Example::ThreePoint, "ambient, diffuse, spot, quadratic, cubic, inverse-square, shadow"),
    (Example::Grid, "diffuse, spot, soft, inverse-square"),
    (Example::WideGrid, "diffuse, spot, soft, inverse-square"),
    (Example::Turntable, "ambient, diffuse, specular, spot, soft, inverse-square"),
    (Example::Show, "diffuse, spot, soft, hard, inverse-square, gobo, haze"),
    (
        Example::Gallery,
        "ambient, diffuse, specular, directional, point, spot, soft, hard, linear, smooth, step, quadratic, cubic, power, \
         inverted-power, real-power, inverted-real-power, table, hotspot, cutoff, unattenuated, inverse-square, polynomial, \
         smooth-range, window, range",
    ),
];

#[test]
fn each_example_calls_for_what_it_shows() {
    assert_eq!(CALLED_FOR.map(|(example, _)| example), Example::ALL);
    for (example, effects) in CALLED_FOR {
        let setup = example.setup().unwrap();
        for seconds in [0.0, 1.3, 100.0] {
            assert_eq!(
                setup.effects_at(seconds).unwrap().to_string(),
                effects,
                "{} at {seconds}",
                example.name()
            );
        }
    }
}

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
