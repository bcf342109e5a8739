//! What is skipped is exactly dark.

use fastrand::Rng;
use luminaire::{Fx16, Fx32};
use support::{falloffs::AnyShape, format::Format, sweep};

/// Skipped light is exactly zero: with and without early-outs the results are bit-identical,
/// inside, outside and at the edge.
fn assert_skipping_is_exact<S: Format>(shape: &AnyShape) {
    let mut rng = Rng::with_seed(64);
    let (mut lit, mut dark) = (0, 0);
    for degrees in sweep::HALF_ANGLES.into_iter().chain([90.0]) {
        let cone = shape.at(degrees);
        if cone.compile::<S>().is_err() {
            continue;
        }
        for _ in 0..4 * sweep::effort() {
            let spot = sweep::spot(&mut rng, cone).with_intensity(100.0).expect("sound");
            let compiled = spot.compile::<S>().expect("held");
            let position = S::exact_point(spot.position().map(S::length));
            let axis = S::exact_direction(spot.axis_in::<S>()).normalize();
            for _ in 0..1_000 {
                let distance = sweep::distance(&mut rng);
                let site = sweep::site::<S>(&mut rng, position, axis, degrees.into(), distance);
                let skipping = compiled.irradiance(site.point, site.normal);
                assert_eq!(skipping, compiled.irradiance_unskipped(site.point, site.normal), "{spot:?}");
                if skipping == S::Irradiance::default() { dark += 1 } else { lit += 1 }
            }
        }
    }
    assert!(lit > 4_000 && dark > 4_000, "the sweep saw {lit} lit and {dark} dark sites");
}

#[test]
fn skipping_is_exact_in_f32() {
    AnyShape::all().iter().for_each(assert_skipping_is_exact::<f32>);
}

#[test]
fn skipping_is_exact_in_fx32() {
    AnyShape::all().iter().for_each(assert_skipping_is_exact::<Fx32>);
}

#[test]
fn skipping_is_exact_in_fx16() {
    AnyShape::all().iter().for_each(assert_skipping_is_exact::<Fx16>);
}
