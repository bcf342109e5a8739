//! What a lit point costs: from a position and a normal in memory to three channels of light added
//! in memory, for 4,096 points.
//!
//! `cargo bench --bench lit`. The rivals are plain loops: one with the formula of the glTF
//! specification, one with Warn's power of a cosine.

#![allow(missing_docs, reason = "criterion's macros make public items without documentation")]

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use luminaire::{
    Angle, Cone, Fx16, Fx32, Rgb, Scalar, SpotLight, Vec3,
    falloff::{Falloff, Hard, Soft},
    light::CompiledSpotLight,
};

const POINTS: usize = 4096;

/// A floor under the light, as a structure of arrays.
struct Floor<S: Scalar> {
    point: Vec3<Vec<S::Length>>,
    normal: Vec3<Vec<S>>,
    light: Rgb<Vec<S::Irradiance>>,
}

/// A square of 64 x 64 points on the floor, two metres wide. A large part of it is inside the cone.
fn floor<S: Scalar>() -> Floor<S> {
    let at = |i: usize| 2.0 * (i as f32 / 63.0) - 1.0;
    let column = |f: &dyn Fn(usize) -> f32| (0..POINTS).map(f).collect::<Vec<_>>();
    let point = Vec3::new(column(&|i| at(i % 64)), column(&|_| 0.0), column(&|i| at(i / 64)));
    let normal = Vec3::new(column(&|_| 0.0), column(&|_| 1.0), column(&|_| 0.0));
    Floor {
        point: point.map(|c| c.into_iter().map(S::length).collect()),
        normal: normal.map(|c| c.into_iter().map(S::from_f32).collect()),
        light: Rgb::new((), (), ()).map(|()| vec![S::Irradiance::default(); POINTS]),
    }
}

fn spot<P: Falloff>(falloff: P) -> SpotLight<P> {
    let cone = Cone::from_field(falloff, Angle::degrees(26.0)).expect("a sound angle");
    SpotLight::new(Vec3::new(0.3, 4.0, 0.2), Vec3::new(-0.05, -1.0, 0.0), cone)
        .and_then(|spot| spot.with_intensity(16.0))
        .and_then(|spot| spot.with_color(Rgb::new(1.0, 0.8, 0.6)))
        .expect("a sound light")
}

/// Lights the floor point by point.
fn light_singly<S: Scalar, P: Falloff>(spot: &CompiledSpotLight<S, P>, floor: &mut Floor<S>) {
    let (point, normal, color) = (&floor.point, &floor.normal, spot.color());
    let (red, green, blue) =
        (&mut floor.light.red[..POINTS], &mut floor.light.green[..POINTS], &mut floor.light.blue[..POINTS]);
    let (x, y, z) = (&point.x[..POINTS], &point.y[..POINTS], &point.z[..POINTS]);
    let (nx, ny, nz) = (&normal.x[..POINTS], &normal.y[..POINTS], &normal.z[..POINTS]);
    for i in 0..POINTS {
        let light = spot.irradiance(Vec3::new(x[i], y[i], z[i]), Vec3::new(nx[i], ny[i], nz[i]));
        red[i] = S::add_light(red[i], S::filter(light, color.red));
        green[i] = S::add_light(green[i], S::filter(light, color.green));
        blue[i] = S::add_light(blue[i], S::filter(light, color.blue));
    }
}

/// Lights the floor in one call.
fn light_batch<S: Scalar, P: Falloff>(spot: &CompiledSpotLight<S, P>, floor: &mut Floor<S>) {
    let Floor { point, normal, light } = floor;
    let Rgb { red, green, blue } = light;
    spot.add_each(columns(point), columns(normal), Rgb::new(red, green, blue));
}

fn columns<T>(columns: &Vec3<Vec<T>>) -> Vec3<&[T]> {
    Vec3::new(&columns.x, &columns.y, &columns.z)
}

fn bench<S: Scalar, P: Falloff>(
    criterion: &mut Criterion,
    name: &str,
    falloff: P,
    light: fn(&CompiledSpotLight<S, P>, &mut Floor<S>),
) {
    let spot = spot(falloff).compile::<S>().expect("held");
    let mut lit = floor::<S>();
    light(&spot, &mut lit);
    let brightest = lit.light.red.iter().map(|&red| S::light_to_f32(red)).fold(0.0, f32::max);
    assert!((0.95..=1.05).contains(&brightest), "{name}: the middle of the spot is {brightest}");
    let mut group = criterion.benchmark_group("lit");
    group.throughput(Throughput::Elements(POINTS as u64));
    group.bench_function(format!("{name} {}", S::NAME), |bencher| {
        bencher.iter(|| light(black_box(&spot), black_box(&mut lit)));
    });
    group.finish();
}

/// Lights the floor by a plain loop. `cone` computes the falloff from the cosine of the angle off
/// axis.
fn light_plainly(floor: &mut Floor<f32>, spot: &SpotLight<Soft>, cone: impl Fn(f32) -> f32) {
    let (position, axis, color) = (spot.position(), spot.axis(), spot.color());
    let (x, y, z) = (&floor.point.x[..POINTS], &floor.point.y[..POINTS], &floor.point.z[..POINTS]);
    let (nx, ny, nz) = (&floor.normal.x[..POINTS], &floor.normal.y[..POINTS], &floor.normal.z[..POINTS]);
    let (red, green, blue) =
        (&mut floor.light.red[..POINTS], &mut floor.light.green[..POINTS], &mut floor.light.blue[..POINTS]);
    for i in 0..POINTS {
        let way = Vec3::new(x[i] - position.x, y[i] - position.y, z[i] - position.z);
        let reciprocal = 1.0 / way.dot(way).sqrt();
        let direction = way.map(|c| c * reciprocal);
        let angular = cone(direction.dot(axis));
        let cosine = (-direction.dot(Vec3::new(nx[i], ny[i], nz[i]))).max(0.0);
        let light = 16.0 * angular * cosine * reciprocal * reciprocal;
        red[i] += light * color.red;
        green[i] += light * color.green;
        blue[i] += light * color.blue;
    }
}

/// Benches the plain loop after checking that the middle of the spot is at full scale.
fn rival(criterion: &mut Criterion, name: &str, cone: impl Fn(f32) -> f32 + Copy) {
    let (spot, mut lit) = (spot(Soft), floor());
    light_plainly(&mut lit, &spot, cone);
    let brightest = lit.light.red.iter().copied().fold(0.0, f32::max);
    assert!((0.95..=1.05).contains(&brightest), "{name}: the middle of the spot is {brightest}");
    let mut group = criterion.benchmark_group("lit");
    group.throughput(Throughput::Elements(POINTS as u64));
    group.bench_function(name, |bencher| {
        bencher.iter(|| light_plainly(black_box(&mut lit), black_box(&spot), cone));
    });
    group.finish();
}

/// The spotlight of glTF's KHR_lights_punctual, with the specification's formula and its ramp
/// squared.
fn gltf(criterion: &mut Criterion) {
    let outer_cosine = 1.0 - spot(Soft).cone().outer_versine();
    let scale = 1.0 / f32::max(0.001, 1.0 - outer_cosine);
    let offset = -outer_cosine * scale;
    rival(criterion, "glTF formula, f32", move |cosine| {
        let angular = (cosine * scale + offset).clamp(0.0, 1.0);
        angular * angular
    });
}

/// Warn's power of the cosine, with the same field angle.
fn warn(criterion: &mut Criterion) {
    let exponent = black_box(0.1_f32.ln() / (1.0 - spot(Soft).cone().field().versine()).ln());
    rival(criterion, "powf (Warn), f32", move |cosine| cosine.max(0.0).powf(exponent));
}

fn lit(criterion: &mut Criterion) {
    gltf(criterion);
    warn(criterion);
    bench::<f32, _>(criterion, "batch, soft", Soft, light_batch);
    bench::<f32, _>(criterion, "batch, hard", Hard, light_batch);
    bench::<f32, _>(criterion, "single, soft", Soft, light_singly);
    bench::<Fx32, _>(criterion, "batch, soft", Soft, light_batch);
    bench::<Fx32, _>(criterion, "single, soft", Soft, light_singly);
    bench::<Fx16, _>(criterion, "batch, soft", Soft, light_batch);
    bench::<Fx16, _>(criterion, "single, soft", Soft, light_singly);
}

criterion_group!(benches, lit);
criterion_main!(benches);
