//! Accuracy of every falloff in all three formats against the f64 reference, row by row of the
//! table of bounds.
//!
//! `cargo test --test suite accuracy:: -- --nocapture` prints the measured rows.

use fastrand::Rng;
use luminaire::{Fx16, Fx32, falloff::Falloff};
use support::{
    bounds::{self, REFUSE},
    falloffs::Shape,
    format::Format,
    oracle::counted,
    sweep::{self, HALF_ANGLES},
    with_every_shape,
};

/// One error for each of [`HALF_ANGLES`].
type Column = [f64; HALF_ANGLES.len()];

/// The largest errors of one falloff in one format.
struct Measured {
    falloff: f64,
    spot: Column,
    lit: Column,
}

/// Versine to intensity, over every cone that the format holds, in steps of the format.
fn falloff_error<S: Format, P: Falloff>(shape: &Shape<P>) -> f64 {
    let held = HALF_ANGLES.into_iter().filter_map(|half| Some((half, shape.at(half).compile::<S>().ok()?)));
    held.flat_map(|(half, falloff)| {
        let exact = shape.stored_at(half);
        sweep::versines(exact.limit, 25_000 * sweep::effort()).map(move |versine| {
            let versine = falloff.versine(versine);
            let stored = S::exact_versine(&falloff, versine);
            if exact.jumps_near(stored, blur::<S>(half)) {
                return 0.0;
            }
            (falloff.at(versine).exact() - exact.falloff(stored)).abs() / f64::from(S::STEP)
        })
    })
    .map(counted)
    .fold(0.0, f64::max)
}

/// How far from a jump, in radians, a point is on its right side: beyond the error of direction,
/// that of length, which counts in wide cones, and that of an angle in f32.
fn blur<S: Format>(half_degrees: f32) -> f64 {
    let radians = f64::from(half_degrees.to_radians());
    f64::from(S::DIRECTION_ERROR) * (3.0 + 8.0 * radians) + 4e-7 * radians
}

/// Position to intensity and to irradiance at one cone, if the format holds it.
fn spot_errors<S: Format, P: Falloff>(shape: &Shape<P>, half_degrees: f32) -> [f64; 2] {
    let mut rng = Rng::with_seed(2004);
    let cone = shape.at(half_degrees);
    if cone.compile::<S>().is_err() {
        return [REFUSE; 2];
    }
    let (mut worst_spot, mut worst_lit) = (0.0_f64, 0.0_f64);
    for _ in 0..50 * sweep::effort() {
        let reach = sweep::distance(&mut rng) as f32;
        let spot = sweep::spot(&mut rng, cone).with_intensity(reach * reach).expect("a sound intensity");
        let exact = sweep::stored::<S, _, _>(&spot, shape.exactly_at(half_degrees));
        let compiled = spot.compile::<S>().expect("the cone compiled");
        for _ in 0..2_000 {
            let distance = f64::from(reach) * (0.7 + 0.7 * rng.f64());
            let site = sweep::site::<S>(&mut rng, exact.position, exact.axis, half_degrees.into(), distance);
            let (point, normal) = (S::exact_point(site.point), S::exact_normal(site.normal));
            if exact.cone.jumps_near(exact.versine(point), blur::<S>(half_degrees)) {
                continue;
            }
            let full_scale = (exact.intensity / point.distance_squared(exact.position)).max(1.0);
            let spot = (compiled.falloff_at(site.point).exact() - exact.falloff(point)).abs();
            let lit = S::exact_light(compiled.irradiance(site.point, site.normal))
                - exact.irradiance(point, normal);
            worst_spot = worst_spot.max(counted(spot));
            worst_lit = worst_lit.max(counted(lit.abs() / full_scale));
        }
    }
    [worst_spot, worst_lit]
}

fn measure<S: Format, P: Falloff>(shape: &Shape<P>) -> Measured {
    let errors = HALF_ANGLES.map(|degrees| spot_errors::<S, P>(shape, degrees));
    Measured {
        falloff: falloff_error::<S, P>(shape),
        spot: errors.map(|[spot, _]| spot),
        lit: errors.map(|[_, lit]| lit),
    }
}

fn show(errors: Column) -> String {
    errors.map(|error| format!("{error:.2e}")).join(", ")
}

/// What a shape breaks of its row.
fn broken<S: Format, P: Falloff>(shape: &Shape<P>) -> Vec<String> {
    if bounds::is_left_out(shape.name) {
        return Vec::new();
    }
    let measured = measure::<S, P>(shape);
    println!("{} {}: falloff {:.3} steps", shape.name, S::NAME, measured.falloff);
    println!("    spot: [{}]", show(measured.spot));
    println!("    lit:  [{}]", show(measured.lit));

    [("falloff", &[measured.falloff][..]), ("spot", &measured.spot), ("lit", &measured.lit)]
        .into_iter()
        .flat_map(|(table, measured)| bounds::broken(table, shape.name, S::NAME, measured))
        .collect()
}

#[test]
fn f32_keeps_its_rows() {
    let broken = with_every_shape!(broken::<f32> -> Vec<String>).concat();
    bounds::assert_kept(&broken);
}

#[test]
fn fx32_keeps_its_rows() {
    let broken = with_every_shape!(broken::<Fx32> -> Vec<String>).concat();
    bounds::assert_kept(&broken);
}

#[test]
fn fx16_keeps_its_rows() {
    let broken = with_every_shape!(broken::<Fx16> -> Vec<String>).concat();
    bounds::assert_kept(&broken);
}
