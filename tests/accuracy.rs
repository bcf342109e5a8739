//! Accuracy of both profiles in all three formats against the f64 reference, row by row of the table of bounds.
//!
//! `cargo test --test accuracy -- --nocapture` prints the measured rows.

mod support;

use fastrand::Rng;
use luminaire::{Cone, Fx16, Fx32, Hard, Profile, Soft, Spot};
use support::{
    bounds::{self, Column, REFUSE, ROWS, Row},
    format::Format,
    reference::{self, Vector},
    sweep::{self, HALF_ANGLES},
};

/// The largest errors of one profile in one format.
struct Measured {
    falloff: f64,
    spot: Column,
    lit: Column,
}

/// Versine to intensity, over every cone that the format holds, in steps of the format.
fn falloff_error<S: Format, P: Profile>(profile: P, oracle: reference::Profile) -> f64 {
    let cones =
        HALF_ANGLES.map(|degrees| Cone::from_outer(profile, sweep::half(degrees)).expect("a sound cone"));
    let held = cones.into_iter().filter_map(|cone| Some((cone, cone.compile::<S>().ok()?)));
    held.flat_map(|(cone, falloff)| {
        let outer = f64::from(cone.outer_versine());
        sweep::versines(outer, 100_000 * sweep::effort()).map(move |versine| {
            let versine = falloff.versine(versine);
            let exact = reference::falloff(oracle, S::exact_versine(&falloff, versine), outer);
            (falloff.at(versine).exact() - exact).abs() / f64::from(S::STEP)
        })
    })
    .fold(0.0, f64::max)
}

/// What the format has stored of a spotlight, for the reference.
fn stored<S: Format, P: Profile>(
    spot: &Spot<P>,
    oracle: reference::Profile,
    half_degrees: f32,
) -> reference::Spot {
    reference::Spot {
        position: S::exact_point(spot.position().map(S::length)),
        axis: reference::unit(S::exact_direction(S::axis(spot.axis()))),
        outer_versine: reference::versine(half_degrees.into()),
        intensity: spot.intensity().into(),
        profile: oracle,
    }
}

/// Position to intensity and to irradiance at one cone, if the format holds it.
fn spot_errors<S: Format, P: Profile>(profile: P, oracle: reference::Profile, half_degrees: f32) -> [f64; 2] {
    let mut rng = Rng::with_seed(2004);
    let cone = Cone::from_outer(profile, sweep::half(half_degrees)).expect("a sound cone");
    if cone.compile::<S>().is_err() {
        return [REFUSE; 2];
    }
    let (mut worst_spot, mut worst_lit) = (0.0_f64, 0.0_f64);
    for _ in 0..100 * sweep::effort() {
        let reach = sweep::distance(&mut rng) as f32;
        let spot = sweep::spot(&mut rng, cone).with_intensity(reach * reach).expect("a sound intensity");
        let exact = stored::<S, P>(&spot, oracle, half_degrees);
        let compiled = spot.compile::<S>().expect("the cone compiled");
        for _ in 0..2_000 {
            let distance = f64::from(reach) * (0.7 + 0.7 * rng.f64());
            let site = sweep::site::<S>(&mut rng, exact.position, exact.axis, half_degrees.into(), distance);
            let (point, normal): (Vector, Vector) =
                (S::exact_point(site.point), S::exact_normal(site.normal));
            let way = reference::minus(point, exact.position);
            let full_scale = (exact.intensity / reference::dot(way, way)).max(1.0);
            let spot = (compiled.falloff(site.point).exact() - exact.falloff(point)).abs();
            let lit = S::exact_light(compiled.irradiance(site.point, site.normal))
                - exact.irradiance(point, normal);
            worst_spot = worst_spot.max(spot);
            worst_lit = worst_lit.max(lit.abs() / full_scale);
        }
    }
    [worst_spot, worst_lit]
}

fn measure<S: Format, P: Profile>(profile: P, oracle: reference::Profile) -> Measured {
    let errors = HALF_ANGLES.map(|degrees| spot_errors::<S, P>(profile, oracle, degrees));
    Measured {
        falloff: falloff_error::<S, P>(profile, oracle),
        spot: errors.map(|[spot, _]| spot),
        lit: errors.map(|[_, lit]| lit),
    }
}

fn show(errors: Column) -> String {
    errors.map(|error| format!("{error:.2e}")).join(", ")
}

fn assert_row<S: Format, P: Profile>(name: &str, profile: P, oracle: reference::Profile) {
    let row: &Row = ROWS
        .iter()
        .find(|row| row.profile == name && row.format == S::NAME)
        .expect("every profile has a row in every format");
    let measured = measure::<S, P>(profile, oracle);
    println!("{name} {}: falloff {:.3} steps", S::NAME, measured.falloff);
    println!("    spot: [{}]", show(measured.spot));
    println!("    lit:  [{}]", show(measured.lit));

    let name = format!("{name} {}", S::NAME);
    let mut broken = Vec::new();
    broken.extend(bounds::check(&format!("{name} falloff"), measured.falloff, row.falloff).err());
    let columns = [("spot", measured.spot, row.spot), ("lit", measured.lit, row.lit)];
    for (column, measured, bound) in columns {
        for ((degrees, measured), bound) in HALF_ANGLES.iter().zip(measured).zip(bound) {
            let cell = format!("{name} {column} at {degrees} degrees");
            broken.extend(bounds::check(&cell, measured, bound).err());
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn soft_f32_keeps_its_row() {
    assert_row::<f32, _>("soft", Soft, reference::soft);
}

#[test]
fn hard_f32_keeps_its_row() {
    assert_row::<f32, _>("hard", Hard, reference::hard);
}

#[test]
fn soft_fx32_keeps_its_row() {
    assert_row::<Fx32, _>("soft", Soft, reference::soft);
}

#[test]
fn hard_fx32_keeps_its_row() {
    assert_row::<Fx32, _>("hard", Hard, reference::hard);
}

#[test]
fn soft_fx16_keeps_its_row() {
    assert_row::<Fx16, _>("soft", Soft, reference::soft);
}

#[test]
fn hard_fx16_keeps_its_row() {
    assert_row::<Fx16, _>("hard", Hard, reference::hard);
}
