//! Monotone functions: falloff and attenuation never rise, and light never falls with the
//! intensity.

use super::format::Format;
use super::scene::{self};
use super::words::Words;
use core::cmp::Ordering;
use luminaire::{
    PointLight, Vec3,
    attenuation::{CutAt, Polynomial, SmoothRange},
    falloff::{AnyFalloff, Soft},
};

/// Falloffs never rise with the versine: the strict falloffs without exception, the others by at
/// most one step, and in `Fx32` by at most 7, as `CompiledCone::at` states.
pub fn falloffs_fall<S: Format>(words: &[u32]) {
    let _: Option<()> = falloff::<S>(&mut Words::new(words));
}

fn falloff<S: Format>(words: &mut Words<'_>) -> Option<()> {
    let falloff = scene::falloff(words)?;
    let cone = scene::cone::<S, _>(words, falloff)?;
    let compiled = cone.compile::<S>().ok()?;
    let is_strict = matches!(
        falloff,
        AnyFalloff::Soft(_)
            | AnyFalloff::Hard(_)
            | AnyFalloff::Linear(_)
            | AnyFalloff::Step(_)
            | AnyFalloff::Power(_)
            | AnyFalloff::InvertedPower(_)
    );
    let steps = match S::NAME {
        _ if is_strict => 0.0,
        "fx32" => 7.0,
        _ => 1.0,
    };
    let slack = steps * f64::from(S::STEP);
    let (a, b) = if words.choice(3) == 0 {
        (S::versine_from_bits(words.wide()), S::versine_from_bits(words.wide()))
    } else {
        let (a, b) = words.pair(1.2 * cone.outer_versine());
        (compiled.versine(a), compiled.versine(b))
    };
    let (inside, outside) = match a.partial_cmp(&b)? {
        Ordering::Greater => (b, a),
        _ => (a, b),
    };
    let (near, far) = (compiled.at(inside).exact(), compiled.at(outside).exact());
    assert!(
        far <= near + slack,
        "{falloff:?} {cone:?}: {near} at {inside:?}, {far} at {outside:?}, expected far <= near + slack"
    );
    Some(())
}

/// Along an axis the tested attenuations never rise with the distance by more than [`rise_steps`],
/// and end at their range.
pub fn distances_fall<S: Format>(words: &[u32]) {
    let _: Option<()> = distance::<S>(&mut Words::tame(words));
}

fn distance<S: Format>(words: &mut Words<'_>) -> Option<()> {
    let range = scene::range(words);
    // Coordinates of fixed point end here.
    let end = if S::NAME == "f32" { f32::MAX } else { 32_767.0 };
    let most = words.one_of([80.0, 1.25 * range]).min(end);
    let (near, step) = (words.between(0.0, most), words.between(0.0, 1.0).powi(8));
    let [near, far] = [near, near + step].map(|distance| (distance * 65_536.0).round() / 65_536.0);
    let source = PointLight::new(Vec3::default()).ok()?;
    let toward = Vec3::new(S::from_f32(-1.0), S::ZERO, S::ZERO);
    let place = |distance: f32| Vec3::new(distance, 0.0, 0.0).map(S::length);
    let [near_light, far_light] = if words.choice(2) == 0 {
        let light = source.with_attenuation(SmoothRange::new(range).ok()?).compile::<S>().ok()?;
        [near, far].map(|distance| light.irradiance(place(distance), toward))
    } else {
        let c = words.numbers(0.0, 4.0);
        let model = CutAt::new(Polynomial::new(c.x, c.y, c.z).ok()?, Some(range)).ok()?;
        let light = source.with_attenuation(model).compile::<S>().ok()?;
        [near, far].map(|distance| light.irradiance(place(distance), toward))
    };
    assert!(
        far < 1.001 * range || far_light == S::Irradiance::default(),
        "{far_light:?} at {far} of {range}"
    );
    // At the position of the light, a point receives no light.
    if near > 0.0 {
        let (near_light, far_light) = (S::exact_light(near_light), S::exact_light(far_light));
        let slack = rise_steps::<S>() * f64::from(S::STEP);
        assert!(
            far_light <= near_light + slack,
            "{words:?}: {near_light} at {near}, {far_light} at {far}, expected far_light <= near_light + slack"
        );
    }
    Some(())
}

/// The number of steps of a format by which an attenuation may rise.
fn rise_steps<S: Format>() -> f64 {
    match S::NAME {
        "f32" => 2.0,
        "fx32" => 8.0,
        _ => 1.0,
    }
}

/// A light of more intensity never lights less.
pub fn intensity_adds<S: Format>(words: &[u32]) {
    let _: Option<()> = intensity::<S>(&mut Words::new(words));
}

fn intensity<S: Format>(words: &mut Words<'_>) -> Option<()> {
    let cone = scene::cone::<S, _>(words, Soft)?;
    let places = scene::places::<S>(words);
    let spot = scene::spot(words, cone, places)?;
    let (point, normal) = (words.point::<S>(places[1]), words.normal::<S>());
    let most = if words.is_end() { 1e9 } else { 1e3 };
    let (a, b) = words.pair(most);
    let (less, more) = (a.min(b), a.max(b));
    let light = |intensity: f32| {
        let light = spot.with_intensity(intensity).ok()?.compile::<S>().ok()?;
        Some(S::exact_light(light.irradiance(point, normal)))
    };
    let (dim, bright) = (light(less)?, light(more)?);
    assert!(
        dim <= bright,
        "{spot:?} {point:?} {normal:?}: {dim} of {less}, {bright} of {more}, expected dim <= bright"
    );
    Some(())
}
