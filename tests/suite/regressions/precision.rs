//! Narrow cones that the numbers could not hold.

use super::case::{ALL, Case, assert_fault};
use fastrand::Rng;
use luminaire::{
    Cone, Fx16, Fx32, HalfAngle,
    falloff::{Linear, Smooth, Soft},
};
use support::assert_that;
use support::{
    bounds::{self, REFUSE},
    format::Format,
    oracle::{self, DVec3},
    sweep::{self, HALF_ANGLES},
};

/// Rounds to the nearest number with `bits` fraction bits.
fn rounded(value: f64, bits: i32) -> f64 {
    let scale = 2.0_f64.powi(bits);
    (value * scale).round() / scale
}

/// The largest error of a soft cone, from random points, where the versine is one less an inner
/// product. The axis as it is stored is taken to be meant.
fn cosine_form(half_degrees: f64, stored: impl Fn(f64) -> f64, product: impl Fn(DVec3, DVec3) -> f64) -> f64 {
    let outer = oracle::versine(half_degrees);
    let mut rng = Rng::with_seed(1983);
    let errors = (0..100_000).map(|_| {
        let axis = sweep::direction(&mut rng).map(&stored);
        let off_axis = rng.f64() * half_degrees.to_radians();
        let way = sweep::direction_off(&mut rng, axis.normalize(), off_axis);
        let exact = oracle::falloff(oracle::soft, oracle::versine_between(way, axis), outer);
        let versine = 1.0 - product(way.map(&stored), axis);
        (oracle::falloff(oracle::soft, versine.max(0.0), outer) - exact).abs()
    });
    errors.fold(0.0, f64::max)
}

/// The largest error of the kernel's soft cone from a position, over random points; nothing where
/// the format refuses it.
fn versine_form<S: Format>(half_degrees: f32) -> Option<f64> {
    let cone = Cone::from_outer(Soft, HalfAngle::degrees(half_degrees)).expect("a sound cone");
    cone.compile::<S>().ok()?;
    let mut rng = Rng::with_seed(2004);
    let mut worst = 0.0_f64;
    for _ in 0..100 {
        let spot = sweep::spot(&mut rng, cone);
        let exact = oracle::Cone::new(oracle::soft, oracle::versine(half_degrees.into()));
        let exact = sweep::stored::<S, _, _>(&spot, exact);
        let compiled = spot.compile::<S>().expect("held");
        for _ in 0..1_000 {
            let distance = sweep::distance(&mut rng);
            let site = sweep::site::<S>(&mut rng, exact.position, exact.axis, half_degrees.into(), distance);
            let point = S::exact_point(site.point);
            if point.distance_squared(exact.position) > 1.0 {
                worst = worst.max((compiled.falloff_at(site.point).exact() - exact.falloff(point)).abs());
            }
        }
    }
    Some(worst)
}

/// The formats that hold a soft cone, each within its cell of the table of bounds.
fn held_by(half_degrees: f32) -> Vec<&'static str> {
    fn held<S: Format>(half_degrees: f32) -> Option<&'static str> {
        let column = HALF_ANGLES.iter().position(|&half| half == half_degrees).expect("a column");
        let bound = bounds::of("spot", "soft", S::NAME).expect("a row")[column];
        let error = versine_form::<S>(half_degrees);
        assert_eq!(error.is_none(), bound == REFUSE);
        let error = error?;
        assert_that!(error <= bound, S::NAME, error);
        Some(S::NAME)
    }
    [held::<f32>(half_degrees), held::<Fx32>(half_degrees), held::<Fx16>(half_degrees)]
        .into_iter()
        .flatten()
        .collect()
}

/// Every spotlight above: `1 - l.dot(s)` cancels. So computed, a beam of 0.1 degrees is off by
/// a fifth of full scale in f32, and a beam of 1 degree by nine tenths of it in 16 bits.
#[test]
fn the_cosine_form_loses_narrow_beams() {
    let f32_of = |value: f64| f64::from(value as f32);
    let f32_product = |a: DVec3, b: DVec3| {
        let [x, y, z] = (a.as_vec3() * b.as_vec3()).to_array();
        f64::from(x + y + z)
    };
    assert_fault(cosine_form(1.0, f32_of, f32_product), 1.7e-3..=2.1e-3);
    assert_fault(cosine_form(0.1, f32_of, f32_product), 0.17..=0.22);
    let fixed = |value: f64| rounded(value, 14);
    let fixed_product = |a: DVec3, b: DVec3| rounded(a.dot(b), 14);
    assert_fault(cosine_form(1.0, fixed, fixed_product), 0.8..=1.0);
    assert_fault(cosine_form(0.1, fixed, fixed_product), 0.99..=1.0);

    assert_eq!(held_by(1.0), ALL);
    assert_eq!(held_by(0.1), ["f32", "fx32"]);
}

/// PlayCanvas, pull request 8108: cosines of cone angles were stored as half floats, whose step
/// below one is 2^-11. Under 1.27 degrees both are one and the cone is nowhere; at 1.3 it is the
/// cone of 1.79.
#[test]
fn playcanvas_stores_cosines_in_half_floats() {
    // From a half to one a half float has 11 fraction bits.
    let stored = |degrees: f64| rounded(1.0 - oracle::versine(degrees), 11);
    assert_eq!(stored(1.2), 1.0);
    assert_fault(stored(1.3).acos().to_degrees(), 1.79..=1.80);
    let narrowest = (1..2_000).map(|i| f64::from(i) / 1_000.0).find(|&degrees| stored(degrees) < 1.0);
    assert_fault(narrowest.expect("there is one"), 1.266..=1.268);

    assert_eq!(Case::open("smooth", Smooth, oracle::smooth, 1.2).held_by(), ALL);
    assert_eq!(Case::open("smooth", Smooth, oracle::smooth, 1.3).held_by(), ALL);
}

/// A cone from 4 to 5 degrees in I8F24 with a plain reciprocal: 731 does not fit, and at the 128
/// that it saturates to, the ramp is at a sixth where it should be one. No project is at fault
/// alone; every fixed-point port meets it.
#[test]
fn a_plain_reciprocal_saturates() {
    let (inner, outer) = (rounded(oracle::versine(4.0), 24), rounded(oracle::versine(5.0), 24));
    let largest = (2.0_f64.powi(31) - 1.0) / 2.0_f64.powi(24);
    assert_fault(1.0 / (outer - inner), 730.0..=732.0);
    let reciprocal = rounded((1.0 / (outer - inner)).min(largest), 24);
    let ramp = |versine: f64| ((outer - versine) * reciprocal).clamp(0.0, 1.0);
    assert_fault(ramp(inner), 0.17..=0.18);
    assert_fault(ramp(0.0), 0.48..=0.49);

    let linear = Case { inner: 4.0, ..Case::open("linear", Linear, oracle::linear, 5.0) };
    assert_eq!(linear.held_by(), ALL);
}
