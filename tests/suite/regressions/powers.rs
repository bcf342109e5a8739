//! Powers and sines that were approximated and not measured.

use super::case::{ALL, Case, assert_fault, assert_ours};
use luminaire::{
    Angle, Cone, Fx16, Fx32, HalfAngle,
    falloff::{Hard, Power, Step},
};
use micromath::F32;
use std::f32::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI, TAU};
use support::assert_that;
use support::{format::Format, oracle};

/// The sharp spotlight of the GameCube's library at the cosine of an angle off axis:
/// `a0 + a1 c + a2 c^2`.
fn sharp(a0: impl Fn(f32, f32) -> f32, cutoff: f32, cosine: f32) -> f32 {
    let edge = cutoff.cos();
    let span = (1.0 - edge) * (1.0 - edge);
    a0(edge, span) + 2.0 / span * cosine - 1.0 / span * cosine * cosine
}

/// encounter/aurora, lib/dolphin/gx/GXLighting.cpp: `a0 = cr * (cr - 2.f)`, without the division
/// that the other two coefficients have, by the square of `1 - cr`. On the axis of a cone of 30
/// degrees the factor is 54.7. With the division it is the paper's hard edge.
#[test]
fn aurora_forgets_a_division_of_the_sharp_spotlight() {
    let cutoff = 30.0_f32.to_radians();
    assert_fault(sharp(|edge, _| edge * (edge - 2.0), cutoff, 1.0), 54.7..=54.8);
    let divided = |edge: f32, span: f32| edge * (edge - 2.0) / span;
    for (degrees, cosine) in
        [0.0_f32, 10.0, 20.0, 29.0, 30.0].map(|degrees| (degrees, degrees.to_radians().cos()))
    {
        let hard = oracle::falloff(oracle::hard, oracle::versine(degrees.into()), oracle::versine(30.0));
        assert_that!((f64::from(sharp(divided, cutoff, cosine)) - hard).abs() < 2e-5, degrees);
    }
    assert_eq!(Case::open("hard", Hard, oracle::hard, 30.0).held_by(), ALL);
}

/// vindar/tgx, src/Renderer3D.inl and .h: 32 samples of the power from the largest argument down,
/// spaced by that argument, and looked up as if they were spaced by one. The power of one is 0.68.
#[test]
fn tgx_looks_up_a_power_table_by_another_spacing() {
    const SIZE: usize = 32;
    let exponent = 16.0_f32;
    let largest = 10.0_f32.powf(1.0 / exponent);
    let table: [f32; SIZE] =
        std::array::from_fn(|k| (largest * (1.0 - k as f32 / SIZE as f32)).powf(exponent));
    let power = |x: f32| {
        let place = (largest - x) * SIZE as f32;
        let index = (place as usize).min(SIZE - 2);
        table[index] + (place - index as f32) * (table[index + 1] - table[index])
    };
    assert_fault(power(1.0), 0.680..=0.688);

    /// The error of a highlight's power over every 2^-14th versine: exhaustive for a versine of 14
    /// bits.
    fn error<S: Format>() -> f64 {
        let ramp = S::ramp(0.0, 1.0, 1.0);
        assert_eq!(S::power(S::versine(ramp, 0.0), 16), S::ONE);
        let versines = (0..=16_384_u16).map(|i| f32::from(i) / 16_384.0);
        let errors = versines.map(|versine| {
            let power = S::power(S::versine(ramp, versine), 16).exact();
            (power - (1.0 - f64::from(versine)).powi(16)).abs()
        });
        errors.fold(0.0, f64::max)
    }
    assert_ours("f32", error::<f32>(), 3.7e-7);
    assert_ours("fx32", error::<Fx32>(), 2e-9);
    assert_ours("fx16", error::<Fx16>(), 6.5e-5);
}

/// micromath 2.1, src/float/powf.rs: `exp(n ln(x))`. The exponent multiplies the error of the
/// logarithm, and at 32 the cosine power of a spotlight is off by a quarter of full scale.
#[test]
fn micromath_magnifies_the_error_of_its_logarithm() {
    let cosines = (1..=10_000_u16).map(|i| f32::from(i) / 10_000.0);
    let errors =
        cosines.map(|cosine| (f64::from(F32(cosine).powf(F32(32.0)).0) - f64::from(cosine).powi(32)).abs());
    assert_fault(255.0 * errors.fold(0.0, f64::max), 60.0..=62.0);

    fn error<S: Format>() -> f64 {
        let cone = Cone::<Power<32>>::opengl(HalfAngle::degrees(90.0)).expect("a sound cutoff");
        let falloff = cone.compile::<S>().expect("held");
        let errors = (0..10_000_u16).map(|i| {
            let versine = falloff.versine(f32::from(i) / 10_000.0);
            let exact = (1.0 - S::exact_versine(&falloff, versine)).powi(32);
            (falloff.at(versine).exact() - exact).abs()
        });
        errors.fold(0.0, f64::max)
    }
    assert_ours("f32", error::<f32>(), 1.5e-6);
    assert_ours("fx32", error::<Fx32>(), 1.5e-8);
    assert_ours("fx16", error::<Fx16>(), 3.3e-5);
}

/// OpenGL's spotlight in GLSL, `pow(cosine, exponent)`, with the default exponent of a light, 0.
/// The manual calls that a uniform distribution, and `pow(0, 0)` undefined. three.js, issue 5222,
/// and OpenMW, pull request 2265, met it in highlights.
#[test]
fn opengl_has_an_exponent_of_zero() {
    let pow = |x: f32, y: f32| (y * x.log2()).exp2();
    assert_eq!(pow(0.5, 0.0), 1.0);
    assert!(pow(0.0, 0.0).is_nan());
    assert_eq!(Case::open("step", Step, oracle::step, 90.0).held_by(), ALL);
}

/// leftger/embedded-gfx, src/lut.rs: a table of the sine by six terms of its series, unreduced over
/// the whole circle. Its test looks at seven angles and allows 0.02. The series leaves the sine
/// beyond 270 degrees, and where the test looks once more saturation hides it; the last entry is
/// off by 0.98.
#[test]
fn embedded_gfx_tests_its_sine_at_seven_angles() {
    let series = |x: f32| {
        let square = x * x;
        let terms = [6.0, 120.0, 5_040.0, 362_880.0, 39_916_800.0_f32];
        let (sum, _) = terms.iter().fold((x, x), |(sum, power), divisor| {
            let power = -power * square;
            (sum + power / divisor, power)
        });
        sum
    };
    let table: [f32; 256] = std::array::from_fn(|i| {
        let value = (series(i as f32 * TAU / 256.0) * 32_768.0) as i16;
        f32::from(value) / 32_768.0
    });
    let error = |index: usize| (table[index] - (index as f32 * TAU / 256.0).sin()).abs();
    let looked_at = [0.0, FRAC_PI_6, FRAC_PI_4, FRAC_PI_3, FRAC_PI_2, PI, 3.0 * FRAC_PI_2];
    assert!(looked_at.iter().all(|angle| error((angle / TAU * 256.0) as usize) < 0.02));
    assert_fault((0..256).map(error).fold(0.0, f32::max), 0.97..=0.98);

    // A versine is where this kernel has its sine: at every hundredth of a degree.
    let versines = (1..=36_000_u16).map(|i| {
        let degrees = f32::from(i) / 100.0;
        let exact = oracle::versine(f64::from(degrees) / 2.0);
        (f64::from(Angle::degrees(degrees).versine()) / exact - 1.0).abs()
    });
    assert_ours("versine", versines.fold(0.0, f64::max), 3e-7);
}
