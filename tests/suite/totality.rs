//! Every bit pattern gives a defined result: no panic and no NaN. The falloff is in [0, 1], exact
//! on the axis and from the edge outwards, and monotone between. Run with overflow checks, as
//! `cargo test` does.

use fastrand::Rng;
use luminaire::{
    Cone, Fx16, Fx32, HalfAngle, SpotLight, Vec3,
    attenuation::{
        AnyAttenuation, Attenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation,
        Polynomial, SmoothRange, Windowed,
    },
    falloff::Soft,
    light::{LightModel, SurfacePoint},
    number::{Offset, Quick, Ray, Share},
    specular::NoSpecular,
};
use support::assert_that;
use support::{
    arbitrary::{bits, vector},
    falloffs::{AnyShape, STRICT},
    format::Format,
    sweep,
};

fn assert_total<S: Format>(shape: &AnyShape) {
    let mut rng = Rng::with_seed(0x0dd_b175);
    for _ in 0..500 * sweep::effort() {
        let cone = shape.at(6.0 + 84.0 * rng.f32());
        let position = vector(&mut rng, |bits| f32::from_bits(bits as u32));
        let axis = vector(&mut rng, |bits| f32::from_bits(bits as u32));
        // Refusing a light is also a defined result.
        let Ok(spot) =
            SpotLight::new(position, axis, cone).and_then(|spot| spot.with_intensity(1e9 * rng.f32()))
        else {
            continue;
        };
        // A fixed-point format also refuses a position outside its range.
        let Ok(compiled) = spot.compile::<S>() else {
            let p = spot.position();
            assert!([p.x, p.y, p.z].into_iter().any(|c| c.abs() > S::FARTHEST), "{spot:?}");
            continue;
        };
        let falloff = cone.compile::<S>().expect("held");
        for _ in 0..100 {
            let point = vector(&mut rng, S::length_from_bits);
            let normal = vector(&mut rng, S::scalar_from_bits);
            let intensity = compiled.falloff_at(point).exact();
            assert_that!((0.0..=1.0).contains(&intensity), spot, point, intensity);
            for light in [compiled.irradiance(point, normal), compiled.irradiance_unskipped(point, normal)] {
                let light = S::exact_light(light);
                assert_that!(light >= 0.0 && light.is_finite(), spot, point, normal, light);
                let sum = S::add_light(S::Irradiance::default(), compiled.irradiance(point, normal));
                assert!(S::exact_light(S::filter(sum, S::ONE)).is_finite());
            }
            assert_eq!(falloff.at(falloff.versine(f32::NAN)), S::ZERO);
            let intensity = falloff.at(S::versine_from_bits(bits(&mut rng))).exact();
            assert_that!((0.0..=1.0).contains(&intensity), cone, intensity);
        }
        // A point at the light has no direction and stays dark.
        let here = spot.position().map(S::length);
        let up = vector(&mut rng, S::scalar_from_bits);
        assert_eq!(compiled.irradiance(here, up), S::Irradiance::default());
    }
}

/// Every bit pattern has an answer in the quick evaluation, and a point at the light is dark.
fn assert_quick_is_total<S: Format + Quick>(shape: &AnyShape) {
    let mut rng = Rng::with_seed(0x0dd_b176);
    for _ in 0..200 * sweep::effort() {
        let position = vector(&mut rng, |bits| f32::from_bits(bits as u32));
        let axis = vector(&mut rng, |bits| f32::from_bits(bits as u32));
        let spot = SpotLight::new(position, axis, shape.at(6.0 + 84.0 * rng.f32()));
        let spot = spot.and_then(|spot| spot.with_intensity(1e9 * rng.f32()));
        let Ok(compiled) = spot.and_then(|spot| spot.compile_quick::<S>()) else { continue };
        for _ in 0..100 {
            let (point, normal) =
                (vector(&mut rng, S::length_from_bits), vector(&mut rng, S::scalar_from_bits));
            let unskipped = compiled.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), false);
            for light in [compiled.irradiance(point, normal), unskipped.diffuse] {
                let light = S::exact_light(light);
                assert_that!(light >= 0.0 && light.is_finite(), compiled, point, normal, light);
            }
        }
        let up = vector(&mut rng, S::scalar_from_bits);
        assert_eq!(compiled.irradiance(position.map(S::length), up), S::Irradiance::default());
    }
}

#[test]
fn every_bit_pattern_has_a_quick_answer() {
    AnyShape::all().iter().for_each(assert_quick_is_total::<f32>);
    AnyShape::all().iter().for_each(assert_quick_is_total::<Fx16>);
}

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
                    let lit = spot.axis().map(|c| S::length(c * distance));
                    let normal = spot.axis().map(|c| S::from_f32(-c));
                    assert_that!(S::exact_light(light.irradiance(lit, normal)) > 0.99, distance);
                }
            }
        }
    }
    assert_dark::<f32>();
    assert_dark::<Fx16>();
}

#[test]
fn every_bit_pattern_has_an_answer_in_f32() {
    AnyShape::all().iter().for_each(assert_total::<f32>);
}

#[test]
fn every_bit_pattern_has_an_answer_in_fx32() {
    AnyShape::all().iter().for_each(assert_total::<Fx32>);
}

#[test]
fn every_bit_pattern_has_an_answer_in_fx16() {
    AnyShape::all().iter().for_each(assert_total::<Fx16>);
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
        for beyond in [outer, outer.next_up(), 1.5 * outer, 2.0] {
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
    assert_eq!(S::ONE.expose(S::gain(1.0)), S::filter(S::ONE.expose(S::gain(1.0)), S::ONE));
    assert_eq!(S::exact_light(S::ONE.expose(S::gain(1.0))), 1.0);
    assert_eq!(S::exact_light(S::ONE.expose(S::gain(f32::NAN))), 0.0);
    assert_eq!(S::exact_light(S::ONE.expose(S::gain(-1.0))), 0.0);
}

#[test]
fn the_laws_of_the_seam_hold() {
    assert_laws::<f32>();
    assert_laws::<Fx32>();
    assert_laws::<Fx16>();
}

/// Asserts that a negative fraction gives no light, directly or with any attenuation.
fn assert_negative_fractions_are_dark<S: Format>() {
    let mut rng = Rng::with_seed(0xda2c);
    let range = Some(9.0);
    let polynomial = Polynomial::new(1.0, 0.2, 0.03).expect("sound");
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
        assert_eq!(fraction.expose(gain), dark, "{fraction:?} {gain:?}");
        let [light, point] = [vector(&mut rng, S::length_from_bits), vector(&mut rng, S::length_from_bits)];
        // Half of the points are near the origin, and so are half of the lights.
        let point = if rng.bool() { light.map(|_| S::length(rng.f32())) } else { point };
        let light = if rng.bool() { light } else { light.map(|_| S::length(rng.f32())) };
        let offset = S::offset(light, point);
        let ray = offset.ray();
        assert_eq!(ray.expose(Share::of_scalar(fraction), gain), dark, "{fraction:?} {gain:?} {offset:?}");
        assert_dark::<S, _>(NoAttenuation, &offset, fraction, gain);
        assert_dark::<S, _>(InverseSquare, &offset, fraction, gain);
        assert_dark::<S, _>(polynomial, &offset, fraction, gain);
        assert_dark::<S, _>(SmoothRange::new(9.0).expect("sound"), &offset, fraction, gain);
        assert_dark::<S, _>(GltfRange::new(InverseSquare, range).expect("sound"), &offset, fraction, gain);
        assert_dark::<S, _>(
            FilamentRange::new(InverseSquare, range).expect("sound"),
            &offset,
            fraction,
            gain,
        );
        assert_dark::<S, _>(CutAt::new(InverseSquare, range).expect("sound"), &offset, fraction, gain);
        assert_dark::<S, _>(Windowed::new(polynomial, range).expect("sound"), &offset, fraction, gain);
        assert_dark::<S, _>(AnyAttenuation::from(InverseSquare), &offset, fraction, gain);
    }
}

fn assert_dark<S: Format, A: Attenuation>(model: A, offset: &S::Offset, fraction: S, gain: S::Gain) {
    let light = A::expose(&model.constants::<S>(), offset, &offset.ray(), Share::of_scalar(fraction), gain);
    assert_eq!(light, S::Irradiance::default(), "{model:?} {fraction:?} {gain:?} {offset:?}");
}

#[test]
fn a_negative_fraction_sends_no_light() {
    assert_negative_fractions_are_dark::<f32>();
    assert_negative_fractions_are_dark::<Fx32>();
    assert_negative_fractions_are_dark::<Fx16>();
}
