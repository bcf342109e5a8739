//! Different ways to compute the same light are bit-identical.

use fastrand::Rng;
use luminaire::number::Arithmetic;
use luminaire::{
    Cone, Fx16, Fx32,
    falloff::{FittedFalloff, Hard, Soft, SoftOrHard},
};
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

/// A falloff chosen at run time and one that is a type are the same light.
#[test]
fn a_choice_at_run_time_changes_no_bit() {
    let mut rng = Rng::with_seed(3);
    for edge in [SoftOrHard::Soft, SoftOrHard::Hard] {
        let cone = Cone::from_field(edge, sweep::half(10.0)).expect("a sound cone");
        let spot = sweep::spot(&mut rng, cone);
        let chosen = spot.compile::<Fx16>().expect("held");
        let position = Fx16::exact_point(spot.position().map(<Fx16 as luminaire::Scalar>::length));
        let axis = Fx16::exact_direction(Fx16::axis(spot.axis())).normalize();
        for _ in 0..10_000 {
            let distance = sweep::distance(&mut rng);
            let site = sweep::site::<Fx16>(&mut rng, position, axis, 10.0, distance);
            let typed = match edge {
                SoftOrHard::Soft => chosen.with_falloff(Soft).irradiance(site.point, site.normal),
                SoftOrHard::Hard => chosen.with_falloff(Hard).irradiance(site.point, site.normal),
            };
            assert_eq!(chosen.irradiance(site.point, site.normal), typed);
        }
    }
}

/// A fitted falloff and the type that it chose are the same falloff.
#[test]
fn a_fitted_profile_changes_no_bit() {
    for field in [14.5, 17.0, 26.0] {
        let cone = Cone::from_beam_and_field(sweep::half(7.0), sweep::half(field / 2.0)).expect("reachable");
        let chosen = cone.compile::<Fx32>().expect("held");
        for versine in sweep::versines(cone.outer_versine().into(), 10_000) {
            let versine = chosen.versine(versine);
            let typed = match cone.falloff() {
                FittedFalloff::Quadratic(quadratic) => chosen.with_falloff(quadratic).at(versine),
                FittedFalloff::Cubic(cubic) => chosen.with_falloff(cubic).at(versine),
            };
            assert_eq!(chosen.at(versine), typed);
        }
    }
}
