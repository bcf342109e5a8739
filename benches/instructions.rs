//! What kernels cost in instructions of the host, counted by callgrind. The counts are the same in
//! every run, whatever else the machine does. Each kernel evaluates 4,096 points or versines.
//!
//! `cargo bench --features callgrind --bench instructions`, with valgrind installed, and
//! gungraun-runner in the version of gungraun that Cargo.lock names
//! (`cargo install gungraun-runner --version 0.20.0`). Programs compiled for wider vectors have
//! other counts. Valgrind supports vectors up to AVX2.

#![allow(missing_docs, reason = "gungraun's macros make public items without documentation")]

use std::hint::black_box;

use gungraun::{library_benchmark, library_benchmark_group, main};
use luminaire::{
    Angle, Cone, Fx16, Fx32, Rgb, Scalar, SpotLight, Vec3,
    falloff::{Falloff, Hard, Smooth, Soft},
    light::{CompiledCone, CompiledSpotLight},
};

const POINTS: usize = 4096;

/// A falloff, versines from the axis to the edge, and room for their intensities.
struct Ramp<S: Scalar, P: Falloff> {
    falloff: CompiledCone<S, P>,
    versines: Vec<S::Versine>,
    intensities: Vec<S>,
}

fn ramp<S: Scalar, P: Falloff>(falloff: P) -> Ramp<S, P> {
    let cone = Cone::from_field(falloff, Angle::degrees(15.0)).expect("a sound angle");
    let falloff = cone.compile::<S>().expect("held");
    let at = |i: usize| falloff.versine(cone.outer_versine() * i as f32 / POINTS as f32);
    Ramp { falloff, versines: (0..POINTS).map(at).collect(), intensities: vec![S::ZERO; POINTS] }
}

#[library_benchmark]
#[bench::soft_f32(ramp::<f32, _>(Soft))]
#[bench::hard_f32(ramp::<f32, _>(Hard))]
#[bench::smooth_f32(ramp::<f32, _>(Smooth))]
#[bench::soft_fx32(ramp::<Fx32, _>(Soft))]
#[bench::soft_fx16(ramp::<Fx16, _>(Soft))]
fn falloff<S: Scalar, P: Falloff>(mut ramp: Ramp<S, P>) -> Ramp<S, P> {
    ramp.falloff.at_each(black_box(&ramp.versines), &mut ramp.intensities);
    ramp
}

/// A spotlight, and a floor under it as a structure of arrays.
struct Floor<S: Scalar> {
    spot: CompiledSpotLight<S, Soft>,
    point: Vec3<Vec<S::Length>>,
    normal: Vec3<Vec<S>>,
    light: Rgb<Vec<S::Irradiance>>,
}

fn floor<S: Scalar>() -> Floor<S> {
    let cone = Cone::from_field(Soft, Angle::degrees(26.0)).expect("a sound angle");
    let spot = SpotLight::new(Vec3::new(0.3, 4.0, 0.2), Vec3::new(-0.05, -1.0, 0.0), cone)
        .and_then(|spot| spot.with_intensity(16.0))
        .and_then(|spot| spot.compile())
        .expect("a sound light");
    let at = |i: usize| S::length(2.0 * (i as f32 / 63.0) - 1.0);
    Floor {
        spot,
        point: Vec3::new(
            (0..POINTS).map(|i| at(i % 64)).collect(),
            vec![S::length(0.0); POINTS],
            (0..POINTS).map(|i| at(i / 64)).collect(),
        ),
        normal: Vec3::new(vec![S::ZERO; POINTS], vec![S::ONE; POINTS], vec![S::ZERO; POINTS]),
        light: Rgb::new((), (), ()).map(|()| vec![S::Irradiance::default(); POINTS]),
    }
}

#[library_benchmark]
#[bench::soft_f32(floor::<f32>())]
#[bench::soft_fx32(floor::<Fx32>())]
#[bench::soft_fx16(floor::<Fx16>())]
fn lit<S: Scalar>(mut floor: Floor<S>) -> Floor<S> {
    let Floor { spot, point, normal, light } = &mut floor;
    let (point, normal) =
        (Vec3::new(&point.x[..], &point.y, &point.z), Vec3::new(&normal.x[..], &normal.y, &normal.z));
    spot.add_each(black_box(point), normal, Rgb::new(&mut light.red, &mut light.green, &mut light.blue));
    floor
}

#[library_benchmark]
fn powf() -> f32 {
    (0..POINTS).map(|i| black_box(1.0 - i as f32 / POINTS as f32).powf(black_box(12.5))).sum()
}

library_benchmark_group!(name = kernels, benchmarks = [falloff, lit, powf]);
main!(library_benchmark_groups = kernels);
