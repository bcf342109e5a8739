//! The experiment of Hast 2004, section 4: equal numbers of calls of `pow` and of the soft edge,
//! and the ratio of their times.
//!
//! `cargo bench --bench paper` makes 100 million calls of each; with `LUMINAIRE_FULL` set it makes
//! the paper's billion. Results are asserted, times are only printed.

#![allow(missing_docs, reason = "a program, not a library")]

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use luminaire::{Angle, Cone, falloff::Soft, light::CompiledCone};

/// The ratio of the times that the paper states.
const PAPER: f64 = 47.7;

/// Number of directions between axis and edge. Each pass evaluates all of them.
const DIRECTIONS: usize = 4096;

/// The soft edge by a call that is not inlined, as `pow` is called.
#[inline(never)]
fn at(soft: &CompiledCone<f32, Soft>, versine: f32) -> f32 {
    soft.at(versine)
}

/// Measures the time of `passes` passes. Returns the time, and the sum of the intensities of the
/// last pass.
fn time(passes: usize, mut pass: impl FnMut(&mut [f32])) -> (Duration, f64) {
    let mut intensities = vec![0.0; DIRECTIONS];
    let start = Instant::now();
    for _ in 0..passes {
        pass(black_box(&mut intensities));
    }
    let duration = start.elapsed();
    (duration, intensities.iter().map(|&intensity| f64::from(intensity)).sum())
}

fn main() {
    let calls: usize = if std::env::var_os("LUMINAIRE_FULL").is_some() { 1_000_000_000 } else { 100_000_000 };
    let passes = calls.div_ceil(DIRECTIONS);
    let cone = Cone::from_field(Soft, Angle::degrees(15.0)).expect("a sound angle");
    let soft: CompiledCone<f32, Soft> = cone.compile().expect("held");
    let outer = cone.outer_versine();
    let versines: Vec<f32> = (0..DIRECTIONS).map(|i| outer * i as f32 / DIRECTIONS as f32).collect();
    let cosines: Vec<f32> = versines.iter().map(|versine| 1.0 - versine).collect();
    // Warn's exponent for the same field angle: the intensity is 1/10 at half that angle off axis.
    let exponent = black_box(0.1_f32.ln() / (1.0 - cone.field().versine()).ln());

    let (soft_batch, sum) = time(passes, |out| soft.at_each(black_box(&versines), out));
    let (soft_single, sum_of_singles) = time(passes, |out| {
        for (out, &versine) in out.iter_mut().zip(&versines) {
            *out = at(&soft, versine);
        }
    });
    let (pow, powers) = time(passes, |out| {
        for (out, &cosine) in out.iter_mut().zip(&cosines) {
            *out = cosine.powf(exponent);
        }
    });
    let (pow_of_doubles, powers_of_doubles) = time(passes, |out| {
        for (out, &cosine) in out.iter_mut().zip(&cosines) {
            *out = f64::from(cosine).powf(exponent.into()) as f32;
        }
    });
    // The mean of t^2 is 1/3. The mean of a power of the cosine follows from its integral.
    let mean = |sum: f64| sum / DIRECTIONS as f64;
    let (edge, power) = (1.0 - f64::from(outer), f64::from(exponent) + 1.0);
    let mean_power = (1.0 - edge.powf(power)) / (power * f64::from(outer));
    assert!((mean(sum) - 1.0 / 3.0).abs() < 1e-3, "the mean of the soft edge is {}", mean(sum));
    assert_eq!(sum, sum_of_singles);
    for sum in [powers, powers_of_doubles] {
        assert!((mean(sum) - mean_power).abs() < 1e-3, "the mean power is {}, not {mean_power}", mean(sum));
    }

    let nanoseconds = |time: Duration| time.as_secs_f64() * 1e9 / (passes * DIRECTIONS) as f64;
    println!("{} calls of each, ns a call:", passes * DIRECTIONS);
    for (name, time) in [
        ("soft, many at once", soft_batch),
        ("soft, one by one", soft_single),
        ("powf of f32", pow),
        ("pow of f64", pow_of_doubles),
    ] {
        println!("{name:>20} {:8.3}", nanoseconds(time));
    }
    let ratio = |slow: Duration, fast: Duration| slow.as_secs_f64() / fast.as_secs_f64();
    println!(
        "pow of f64 against soft: one by one {:.1}, many at once {:.1}; the paper: {PAPER}",
        ratio(pow_of_doubles, soft_single),
        ratio(pow_of_doubles, soft_batch)
    );
    println!(
        "powf of f32 against soft: one by one {:.1}, many at once {:.1}",
        ratio(pow, soft_single),
        ratio(pow, soft_batch)
    );
}
