//! What a falloff costs, from a versine in memory to an intensity in memory: 4,096 evaluations, in
//! batches and one by one.
//!
//! `cargo bench --bench falloff`. A clamped copy is the lower bound of any method.
//! `RUSTFLAGS=-Ctarget-feature=+avx2` before the command allows wider vectors than the target's
//! default.

#![allow(missing_docs, reason = "criterion's macros make public items without documentation")]

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use luminaire::{
    Angle, Cone, Fx16, Fx32, Scalar,
    falloff::{Cubic, Falloff, Hard, Power, Smooth, Soft},
    light::CompiledCone,
};

const POINTS: usize = 4096;

/// The versines of a field angle of 15 degrees, from the axis to a little beyond the edge.
fn versines(outer: f32) -> Vec<f32> {
    (0..POINTS).map(|i| 1.1 * outer * i as f32 / POINTS as f32).collect()
}

fn cone<P: Falloff>(falloff: P) -> Cone<P> {
    Cone::from_field(falloff, Angle::degrees(15.0)).expect("a sound angle")
}

/// Evaluates one versine after the other, each by a call that is not inlined, as `powf` is called.
fn evaluate<S: Scalar, P: Falloff>(falloff: &CompiledCone<S, P>, versines: &[S::Versine], out: &mut [S]) {
    for (out, versine) in out.iter_mut().zip(versines) {
        *out = at(falloff, *versine);
    }
}

#[inline(never)]
fn at<S: Scalar, P: Falloff>(falloff: &CompiledCone<S, P>, versine: S::Versine) -> S {
    falloff.at(versine)
}

/// Benches a falloff, after checking that it is one half at the beam angle.
fn bench<S: Scalar, P: Falloff>(criterion: &mut Criterion, name: &str, falloff: P) {
    let cone = cone(falloff);
    let falloff = cone.compile::<S>().expect("held");
    let at_beam = falloff.at(falloff.versine(cone.beam().versine())).to_f32();
    assert!((at_beam - 0.5).abs() < 1e-3, "{name} is {at_beam} at the beam angle");
    let versines: Vec<_> = versines(cone.outer_versine()).into_iter().map(|w| falloff.versine(w)).collect();
    let mut out = vec![S::ZERO; POINTS];
    let mut group = criterion.benchmark_group("falloff");
    group.throughput(Throughput::Elements(POINTS as u64));
    group.bench_function(format!("{name} {}, batch", S::NAME), |bencher| {
        bencher.iter(|| falloff.at_each(black_box(&versines), black_box(&mut out)));
    });
    group.bench_function(format!("{name} {}, single", S::NAME), |bencher| {
        bencher.iter(|| evaluate(&falloff, black_box(&versines), black_box(&mut out)));
    });
    group.finish();
}

/// Benches a formula in f32 for comparison, after checking that its value at the field angle is
/// `at_field`.
fn rival(criterion: &mut Criterion, name: &str, at_field: f32, formula: impl Fn(f32) -> f32) {
    let found = formula(cone(Soft).field().versine());
    assert!((found - at_field).abs() < 1e-3, "{name} is {found} at the field angle");
    let versines = versines(cone(Soft).outer_versine());
    let mut out = vec![0.0; POINTS];
    let mut group = criterion.benchmark_group("falloff");
    group.throughput(Throughput::Elements(POINTS as u64));
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            for (out, versine) in out.iter_mut().zip(black_box(&versines)) {
                *out = formula(*versine);
            }
            black_box(&mut out);
        });
    });
    group.finish();
}

fn falloffs(criterion: &mut Criterion) {
    let outer = cone(Soft).outer_versine();
    // The exponent `C` with which Warn's model has the same field angle: cos^C = 1/10 at the half
    // angle.
    let exponent = black_box(0.1_f32.ln() / (1.0 - cone(Soft).field().versine()).ln());
    let cubic = Cubic::with_slopes(1.25, 3.5).expect("sound slopes");
    let field = cone(Soft).field().versine();
    rival(criterion, "clamped copy", field, |versine| if versine < outer { versine } else { outer });
    bench::<f32, _>(criterion, "soft", Soft);
    bench::<f32, _>(criterion, "hard", Hard);
    bench::<f32, _>(criterion, "smooth", Smooth);
    bench::<f32, _>(criterion, "cubic", cubic);
    bench::<f32, _>(criterion, "power 16", Power::<16>);
    bench::<Fx32, _>(criterion, "soft", Soft);
    bench::<Fx16, _>(criterion, "soft", Soft);
    bench::<Fx16, _>(criterion, "smooth", Smooth);
    bench::<Fx16, _>(criterion, "cubic", cubic);
    bench::<Fx16, _>(criterion, "power 16", Power::<16>);
    rival(criterion, "powf (Warn)", 0.1, |versine| (1.0 - versine).powf(exponent));
}

criterion_group!(benches, falloffs);
criterion_main!(benches);
