//! Falloffs are exact on the axis and from the edge outwards, and never rise between. What is
//! skipped is exactly dark, and no negative number becomes light.

use fastrand::Rng;
use luminaire::{
    Cone, Fx16, Fx32, HalfAngle, SpotLight, Vec3,
    attenuation::{AnyAttenuation, Attenuation, NoAttenuation},
    falloff::Soft,
    number::{Offset, Quick, Ray, Share},
};
use support::{
    arbitrary::{bits, vector},
    assert_in, assert_that,
    falloffs::{AnyShape, STRICT},
    format::Format,
    in_every_format, sweep,
};

/// Behind a light there is no light, up to the opposite direction, where the difference of the
/// directions is largest.
#[test]
fn a_quick_light_does_not_shine_backwards() {
    fn assert_dark<S: Format + Quick>() {
        for axis in [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.6, 0.0, 0.8], [-0.577, 0.577, -0.577]] {
            for degrees in [0.8, 20.0, 60.0, 90.0] {
                let cone = Cone::from_outer(Soft, HalfAngle::degrees(degrees)).expect("sound");
                let spot = SpotLight::new(Vec3::default(), Vec3::from(axis), cone).expect("sound");
                let light = spot.with_attenuation(NoAttenuation).compile_quick::<S>().expect("held");
                for distance in [0.001, 0.4999, 0.5, 1.0, 1.99, 63.99, 64.0, 9_000.0] {
                    let point = spot.axis().map(|c| S::length(-c * distance));
                    let normal = spot.axis().map(S::from_f32);
                    assert_eq!(light.irradiance(point, normal), S::Irradiance::default(), "{axis:?}");
                    let at_the_light = light.irradiance(Vec3::default(), normal);
                    assert_eq!(at_the_light, S::Irradiance::default(), "{axis:?}");
                    let lit = spot.axis().map(|c| S::length(c * distance));
                    let normal = spot.axis().map(|c| S::from_f32(-c));
                    assert_in(&(axis, distance), S::exact_light(light.irradiance(lit, normal)), 0.99..=1.01);
                }
            }
        }
    }
    assert_dark::<Fx16>();
}

/// Asserts that the falloff is exactly 1 on the axis and exactly 0 at the edge and beyond. Between
/// them it never rises: the falloffs in `STRICT` without exception, the others by at most one step
/// of the format.
fn assert_exact_at_both_ends<S: Format>(shape: &AnyShape) {
    let slack = if STRICT.contains(&shape.name) { 0.0 } else { f64::from(S::STEP) };
    for degrees in sweep::HALF_ANGLES.into_iter().chain([90.0]) {
        let cone = shape.at(degrees);
        let Ok(falloff) = cone.compile::<S>() else { continue };
        let outer = cone.outer_versine();
        assert_eq!(falloff.at(falloff.versine(0.0)), S::ONE);
        if cone.inner().to_degrees() > 0.0 {
            assert_eq!(falloff.at(falloff.versine(cone.inner().versine() * 0.999_999)), S::ONE);
        }
        for beyond in [outer, outer.next_up(), 1.5 * outer, 2.0, f32::NAN] {
            assert_eq!(falloff.at(falloff.versine(beyond)), S::ZERO, "{} {degrees} {beyond}", shape.name);
        }
        let steps = 20_000;
        let mut previous = 1.0;
        for versine in (0..=steps).map(|i| outer * (i as f32 / steps as f32)) {
            let intensity = falloff.at(falloff.versine(versine)).exact();
            let name = shape.name;
            assert!(intensity <= previous + slack, "{name} {degrees}: {intensity:?} after {previous:?}");
            previous = intensity;
        }
    }
}

#[test]
fn both_ends_are_exact() {
    AnyShape::all().iter().for_each(assert_exact_at_both_ends::<f32>);
    AnyShape::all().iter().for_each(assert_exact_at_both_ends::<Fx32>);
    AnyShape::all().iter().for_each(assert_exact_at_both_ends::<Fx16>);
}

/// Asserts the laws of the table in the core's `scalar` module, on random bits and on special
/// values.
fn assert_laws<S: Format>() {
    let mut rng = Rng::with_seed(5);
    for _ in 0..100_000 {
        let (a, b) = (S::scalar_from_bits(bits(&mut rng)), S::scalar_from_bits(bits(&mut rng)));
        if a.exact().is_finite() {
            assert_eq!(a.minus(S::ZERO), a);
        }
        let part = S::from_f32(rng.f32());
        assert_eq!((S::ONE.times(part), part.times(S::ONE)), (part, part));
        if S::NAME != "f32" {
            assert_that!((S::ZERO..=S::ONE).contains(&a.times(b)), a, b);
        }
        assert_eq!(format!("{:?}", a.times(b)).contains("NaN"), (a.exact() * b.exact()).is_nan());
    }
    for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0, 1.0, -1.0, 1e30] {
        assert!(!S::from_f32(value).exact().is_nan());
    }
    assert_eq!(S::from_f32(1.0), S::ONE);
    assert_eq!(S::ONE.light(S::gain(1.0)), S::filter(S::ONE.light(S::gain(1.0)), S::ONE));
    assert_eq!(S::exact_light(S::ONE.light(S::gain(1.0))), 1.0);
    assert_eq!(S::exact_light(S::ONE.light(S::gain(f32::NAN))), 0.0);
    assert_eq!(S::exact_light(S::ONE.light(S::gain(-1.0))), 0.0);
}

#[test]
fn the_laws_of_the_seam_hold() {
    in_every_format!(assert_laws);
}

/// Asserts that a negative fraction gives no light, directly or with any attenuation.
fn assert_negative_fractions_are_dark<S: Format>() {
    let mut rng = Rng::with_seed(0xda2c);
    let drawn = |index| AnyAttenuation::drawn(index, || 0.225).expect("sound");
    let models: Vec<_> = (0..AnyAttenuation::COUNT).map(drawn).collect();
    let mut tried = 0;
    while tried < 100_000 {
        let fraction = S::scalar_from_bits(bits(&mut rng));
        let is_negative = fraction < S::ZERO;
        if !is_negative {
            continue;
        }
        tried += 1;
        let gain = S::gain(f32::from_bits(rng.u32(..)).abs());
        let dark = S::Irradiance::default();
        assert_eq!(fraction.light(gain), dark, "{fraction:?} {gain:?}");
        let [light, point] = [vector(&mut rng, S::length_from_bits), vector(&mut rng, S::length_from_bits)];
        // Half of the points are near the origin, and so are half of the lights.
        let point = if rng.bool() { light.map(|_| S::length(rng.f32())) } else { point };
        let light = if rng.bool() { light } else { light.map(|_| S::length(rng.f32())) };
        let offset = S::Offset::between(light, point);
        let ray = offset.ray();
        assert_eq!(ray.light(Share::of_scalar(fraction), gain), dark, "{fraction:?} {gain:?} {offset:?}");
        for model in &models {
            let constants = model.constants::<S>();
            let light = AnyAttenuation::light(&constants, &offset, &ray, Share::of_scalar(fraction), gain);
            assert_eq!(light, dark, "{model:?} {fraction:?} {gain:?} {offset:?}");
        }
    }
}

#[test]
fn a_negative_fraction_sends_no_light() {
    in_every_format!(assert_negative_fractions_are_dark);
}
