//! Powers as edge falloffs, with integer and non-integer exponents up to the largest: the figures
//! that set-up computes and the intensities, compared with f64. `cargo test --test slow powers:: --
//! --nocapture --test-threads 1` prints the errors.

use fastrand::Rng;
use luminaire::{
    Angle, Cone, Fx16, Fx32, HalfAngle, SpotLight, Vec3,
    falloff::{Falloff, IntegerPower, InvertedIntegerPower, InvertedRealPower, RealPower},
};
use support::{
    bounds::{self, REFUSE},
    format::Format,
    oracle::{self, DVec3},
    sweep,
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
    let of_rim = [if is_boundless { STRIP * STRIP } else { 0.0 }, 1.0];
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
    (0.3,     [[7.3e-8, 1.9e-4], [5.5e-9, 5.3e-9], [3.3e-5, 3.3e-5]]),
    (0.75,    [[1.2e-7, 1.6e-6], [2.0e-9, 2.1e-9], [9.6e-5, 2.7e-4]]),
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

/// The largest error in linear codes of an inverted power on and near its axis, of points and axes of any direction,
/// where the exact one may be anywhere within the strip about the point.
fn beside_axis<S: Format>(exponent: f32, half_angle: f64) -> f64 {
    let power = InvertedRealPower::new(exponent).expect("a sound exponent");
    let cone = Cone::from_outer(power, HalfAngle::radians(half_angle as f32)).expect("a sound angle");
    let outer = f64::from(cone.outer_versine());
    let falloff =
        |angle: f64| 1.0 - (oracle::versine(angle.to_degrees()) / outer).min(1.0).powf(exponent.into());
    let mut rng = Rng::with_seed(45);
    let mut worst = 0.0_f64;
    for _ in 0..20_000 {
        // Coordinates that all formats have exactly.
        let way = sweep::direction(&mut rng) * 8_192.0 * rng.f64().exp2();
        let way = way.to_array().map(|c| (c * 1_024.0).round() as f32 / 1_024.0);
        let light = SpotLight::new([0.0; 3], way, cone).and_then(|light| light.compile::<S>());
        let exact = DVec3::from_array(way.map(f64::from));
        let off = half_angle * 0.02 * rng.f64().powi(3);
        let point = sweep::single(sweep::direction_off(&mut rng, exact.normalize(), off) * exact.length());
        let point = if rng.bool() { Vec3::from(way) } else { point };
        let point = point.map(S::length);
        let found = light.expect("a sound light").falloff_at(point).exact();
        let angle = oracle::half_degrees(oracle::versine_between(S::exact_point(point), exact)).to_radians();
        let strip = STRIP * half_angle;
        let [most, least] = [(angle - strip).max(0.0), angle + strip].map(falloff);
        worst = worst.max(oracle::counted((found - most).max(least - found)));
    }
    255.0 * worst
}

/// Where its slope is infinite, an inverted power keeps to half a linear code but for a strip, in the narrowest
/// cone and in wide ones.
#[test]
fn inverted_powers_keep_to_half_a_code_beside_their_axis() {
    fn assert<S: Format>() {
        for exponent in [f32::from_bits(1), 1e-4, 0.01, 0.1, 0.3, 0.416, 0.45, 0.6, 0.9, 0.99] {
            let power = InvertedRealPower::new(exponent).expect("a sound exponent");
            let narrowest = f64::from(Cone::narrowest::<S>(power).to_radians()) / 2.0 * 1.000_1;
            for half_angle in [narrowest, 2.0 * narrowest, 0.01, 0.1, 0.5, 1.5] {
                if half_angle >= narrowest && half_angle < 1.57 {
                    let codes = beside_axis::<S>(exponent, half_angle);
                    println!("{} {exponent} {half_angle:.2e}: {codes:.3} codes", S::NAME);
                    assert!(codes <= 0.5, "{} {exponent} {half_angle}: {codes} codes", S::NAME);
                }
            }
        }
    }
    assert::<f32>();
    assert::<Fx32>();
    assert::<Fx16>();
}
