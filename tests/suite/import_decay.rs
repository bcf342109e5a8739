//! The attenuation of imported lights: decays, and their limits next to the light.

use luminaire::{attenuation::AnyAttenuation, import::Imported};
use support::{assert_that, imports};

use crate::import::{distance_difference, fall, on_axis};

/// Without a constant coefficient the light grows without a bound towards the light: nearer than
/// 0.001 it is that of 0.001.
#[test]
fn a_polynomial_without_a_constant_stops_growing() {
    for [linear, quadratic] in [[1.0, 1_000.0], [2.0, 0.0], [0.5, 4.0e5]] {
        let (light, _) = imports::opengl(30.0, 1.0, [0.0, linear, quadratic]);
        assert!(matches!(light.light.attenuation(), AnyAttenuation::Polynomial(_)));
        let stopped = 1.0 / f64::from(1e-3 * (linear + 1e-3 * quadratic));
        for distance in [0.0, 0.000_9, 0.001_1, 2.0] {
            let exact = 1.0 / (distance * (f64::from(linear) + distance * f64::from(quadratic)));
            let found = fall(&light.light, distance);
            assert_that!((found / exact.min(stopped) - 1.0).abs() < 1e-6, found, distance);
        }
    }
    let (inverse_square, _) = imports::opengl(30.0, 1.0, [0.0, 0.0, 2.0]);
    assert!(matches!(inverse_square.light.attenuation(), AnyAttenuation::InverseSquare(_)));
    // A constant is the light at the light itself.
    let (light, _) = imports::opengl(30.0, 1.0, [0.25, 3.0, 4.0]);
    assert_eq!(fall(&light.light, 0.0), 4.0);
    // A constant so small that the others would exceed 1e9 in units of it.
    let (light, _) = imports::opengl(30.0, 1.0, [1e-6, 0.0, 1e4]);
    assert!((fall(&light.light, 1.0) * 1e4 - 1.0).abs() < 1e-6);
}

/// Near to the light an imported decay stops growing where the original does.
#[test]
fn a_decay_stops_growing_where_its_original_does() {
    for decay in [1.1, 1.5, 1.9, 3.0] {
        let three = imports::three(0.6, 0.3, 8.0, decay);
        let godot = imports::godot(45.0, 2.0, 8.0, decay.min(1.9));
        for (Imported { light, .. }, original) in [three, godot] {
            let (found, exact) = (fall(&light, 0.0) / on_axis(&light, &original), (original.distance)(0.0));
            assert!((found / exact - 1.0).abs() < 1e-5, "{}: {found} at the light, {exact}", original.name);
        }
    }
}

/// Godot's factor exceeds 2^64 next to a light with a steep decay and a short range.
#[test]
fn the_difference_of_a_very_bright_light_is_that_of_its_cap() {
    for (decay, range) in [(5.0, 0.002), (5.5, 0.003), (16.0, 0.01)] {
        let (Imported { light, difference }, original) = imports::godot(45.0, 0.5, range, decay);
        let range = f64::from(range);
        let compared = [original.stop.max(range / 16.0), range];
        let (found, stated) =
            (distance_difference(&light, &original, compared), f64::from(difference.distance));
        let holds = found > 0.01 && stated >= found - 1e-6 && stated <= 1.02 * found + 1e-6;
        assert!(holds, "{decay} {range}: {found:.5e} is stated as {stated:.5e}");
    }
}
