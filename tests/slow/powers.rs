//! Powers as edge falloffs, with integer and non-integer exponents up to the largest: the figures
//! that set-up computes and the intensities, compared with f64. `cargo test --test slow powers:: --
//! --nocapture --test-threads 1` prints the errors.

use luminaire::{
    Angle, Cone, Fx16, Fx32,
    falloff::{Falloff, IntegerPower, InvertedIntegerPower, InvertedRealPower, RealPower},
};
use support::{
    bounds::{self, REFUSE},
    format::Format,
    oracle, sweep,
};

fn relative(found: f32, exact: f64) -> f64 {
    (f64::from(found) / exact - 1.0).abs()
}

/// `1 - value^(1 / n)`.
fn lost(value: f64, n: f64) -> f64 {
    -(value.ln() / n).exp_m1()
}

/// The largest relative errors, over every integer exponent, of the figures that cones are designed
/// and checked with: beam, field, integral and steepness.
#[test]
fn every_whole_exponent_keeps_its_figures() {
    const HOTSPOTS: [f32; 5] = [0.0, 1e-4, 0.01, 0.5, 0.999];
    let mut worst = [0.0_f64; 6];
    let mut note = |i: usize, error: f64| worst[i] = worst[i].max(oracle::counted(error));
    for exponent in 1..=1_024_u16 {
        let n = f64::from(exponent);
        let power = IntegerPower::new(exponent.into()).expect("a sound exponent");
        let rim = InvertedIntegerPower::new(exponent.into()).expect("a sound exponent");
        note(0, relative(power.beam_versine(), lost(0.5, n)));
        note(0, relative(power.field_versine(), lost(0.1, n)));
        note(1, relative(rim.beam_versine(), 1.0 - lost(0.5, n)));
        note(1, relative(rim.field_versine(), 1.0 - lost(0.9, n)));
        for u in [1e-7_f32, 1e-4, 0.003, 0.1, 0.7, 1.0] {
            let x = f64::from(u);
            let of_power = -((n + 1.0) * (-x).ln_1p()).exp_m1() / (n + 1.0);
            note(2, relative(power.integral(u), of_power));
            note(3, relative(rim.integral(u), x - x.powf(n + 1.0) / (n + 1.0)));
        }
        for hotspot in HOTSPOTS {
            let h = f64::from(hotspot);
            let v = (1.0 / (2.0 * n - 1.0)).max(h);
            let slope = 2.0 * n * ((1.0 - v) / (1.0 - h)).powf(n - 1.0) * v.sqrt() / (1.0 - h);
            note(4, relative(power.steepness(hotspot), slope));
            note(5, relative(rim.steepness(hotspot), 2.0 * n / (1.0 - h)));
        }
    }
    const FIGURES: [(&str, f64); 6] = [
        ("beam and field of a power", 2e-7),
        ("beam and field of an inverted power", 5e-8),
        ("integral of a power", 1.5e-7),
        ("integral of an inverted power", 8e-8),
        ("steepness of a power", 2e-7),
        ("steepness of an inverted power", 1e-7),
    ];
    for ((name, bound), worst) in FIGURES.into_iter().zip(worst) {
        println!("{name:28} {worst:.2e}");
        bounds::check(name, worst, bound).expect("within its bound");
    }
}

/// Width of the strip in which a real power with an exponent under 1 is not compared, because its
/// slope has no bound there: 1/510 of the half angle, at the edge of a power and on the axis of an
/// inverted power.
const STRIP: f64 = 1.0 / 510.0;

/// The largest error of a falloff's intensity in a cone of 180 degrees, between two versines given
/// as fractions of the outer one. `REFUSE` if the format refuses the cone.
fn error<S: Format, P: Falloff>(falloff: P, exact: impl Fn(f64) -> f64, [from, to]: [f64; 2]) -> f64 {
    let cone = Cone::from_outer(falloff, Angle::degrees(180.0)).expect("a sound angle");
    let Ok(falloff) = cone.compile::<S>() else { return REFUSE };
    let outer = f64::from(cone.outer_versine());
    let (axis, edge) = (falloff.at(falloff.versine(0.0)).exact(), falloff.at(falloff.versine(1.0)).exact());
    assert_eq!((axis, edge), (1.0, 0.0), "{falloff:?}");
    let count = 50_000 * sweep::effort() as u32;
    (0..=count)
        .map(|i| {
            let place = f64::from(i) / f64::from(count);
            let (near, far) = (place.powi(4), (1.0 - place).powi(4));
            let versine = falloff.versine((from + (to - from) * near / (near + far)) as f32);
            let found = falloff.at(versine).exact();
            assert!((0.0..=1.0).contains(&found), "{falloff:?}: {found}");
            (found - exact((S::exact_versine(&falloff, versine) / outer).min(1.0))).abs()
        })
        .map(oracle::counted)
        .fold(0.0, f64::max)
}

/// The errors of the power with this exponent, and of the inverted power.
fn errors<S: Format>(exponent: f32) -> [f64; 2] {
    let p = f64::from(exponent);
    let is_boundless = exponent < 1.0;
    let of_power = [0.0, if is_boundless { (1.0 - STRIP).powi(2) } else { 1.0 }];
    // In 16 bits `u` has steps of 2^-16 near the axis, which are wider than the strip.
    let begin = if S::NAME == "fx16" { 0.01 } else { STRIP * STRIP };
    let of_rim = [if is_boundless { begin } else { 0.0 }, 1.0];
    if exponent.fract() == 0.0 {
        let power = IntegerPower::new(exponent as u32).expect("sound");
        let rim = InvertedIntegerPower::new(exponent as u32).expect("sound");
        let of_power = error::<S, _>(power, |u| (1.0 - u).powf(p), of_power);
        return [of_power, error::<S, _>(rim, |u| 1.0 - u.powf(p), of_rim)];
    }
    let (power, rim) =
        (RealPower::new(exponent).expect("sound"), InvertedRealPower::new(exponent).expect("sound"));
    [error::<S, _>(power, |u| (1.0 - u).powf(p), of_power), error::<S, _>(rim, |u| 1.0 - u.powf(p), of_rim)]
}

/// The largest errors of the power and the inverted power in `f32`, `Fx32` and `Fx16`.
#[rustfmt::skip]
const ROWS: [(f32, [[f64; 2]; 3]); 12] = [
    (0.1,     [[4.6e-8, 7.2e-4], [5.3e-9, 4.7e-9], [3.3e-5, 3.3e-5]]),
    (0.3,     [[7.3e-8, 1.9e-4], [5.5e-9, 5.3e-9], [3.3e-5, 1.7e-4]]),
    (0.75,    [[1.2e-7, 1.6e-6], [2.0e-9, 2.1e-9], [9.6e-5, 8.3e-5]]),
    (1.5,     [[1.9e-7, 1.2e-7], [2.5e-9, 2.8e-9], [7.4e-5, 7.3e-5]]),
    (2.2,     [[2.5e-7, 1.2e-7], [3.1e-9, 3.7e-9], [8.4e-5, 8.4e-5]]),
    (7.5,     [[7.5e-7, 1.4e-7], [7.4e-9, 1.1e-8], [1.7e-4, 3.3e-5]]),
    (33.3,    [[3.2e-6, 7.3e-8], [2.8e-8, 3.8e-8], [3.3e-5, 3.3e-5]]),
    (128.0,   [[1.5e-5, 2.9e-6], [1.3e-7, 1.9e-7], [3.3e-5, REFUSE]]),
    (127.5,   [[1.2e-5, 1.1e-7], [1.1e-7, 1.5e-7], [3.3e-5, REFUSE]]),
    (268.0,   [[3.0e-5, 5.5e-6], [2.7e-7, 3.9e-7], [3.3e-5, REFUSE]]),
    (1_024.0, [[9.8e-5, 2.0e-5], [1.0e-6, 1.5e-6], [3.3e-5, REFUSE]]),
    (1_023.9, [[9.8e-5, 6.2e-7], [8.6e-7, 1.2e-6], [3.3e-5, REFUSE]]),
];

#[test]
fn real_powers_keep_their_rows() {
    let mut wrong = Vec::new();
    for (exponent, bounds) in ROWS {
        let found = [errors::<f32>(exponent), errors::<Fx32>(exponent), errors::<Fx16>(exponent)];
        println!(
            "{exponent:8}: {:.1e} {:.1e} | {:.1e} {:.1e} | {:.1e} {:.1e}",
            found[0][0], found[0][1], found[1][0], found[1][1], found[2][0], found[2][1]
        );
        for (found, bound) in found.as_flattened().iter().zip(bounds.as_flattened()) {
            wrong.extend(bounds::check(&format!("exponent {exponent}"), *found, *bound).err());
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
