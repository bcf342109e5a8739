//! The reasons for the number formats: models of the candidates in f64, with every value rounded to
//! the bits that it would have, and the largest error of each candidate. `docs/NUMERICS.md` quotes
//! the tables that this prints:
//!
//! `cargo test --test suite formats:: -- --nocapture`

use fastrand::Rng;
use support::{
    oracle::{self, DVec3},
    sweep,
};

const HALF_A_STEP: f64 = 1.0 / 510.0;
const POINTS: usize = 40_000;

/// The nearest multiple of `2^-bits`.
fn rounded(value: f64, bits: i32) -> f64 {
    let scale = 2.0_f64.powi(bits);
    (value * scale).round() / scale
}

/// Takes an offset of any length to the unit direction that a candidate would compute.
type Normalise<'a> = &'a dyn Fn(DVec3) -> DVec3;

/// The largest error of a falloff at a half angle, when the versine is half the squared difference
/// of the candidate's direction and the axis, and all else is exact.
fn difference_error(normalise: Normalise, falloff: oracle::Falloff, half_degrees: f64) -> f64 {
    largest_error(falloff, half_degrees, |way, axis| normalise(way).distance_squared(axis) / 2.0)
}

fn largest_error(falloff: oracle::Falloff, half_degrees: f64, versine: impl Fn(DVec3, DVec3) -> f64) -> f64 {
    let outer = oracle::versine(half_degrees);
    let mut rng = Rng::with_seed(11);
    (0..POINTS)
        .map(|_| {
            let axis = sweep::direction(&mut rng);
            let off_axis = rng.f64() * half_degrees.to_radians();
            let way = sweep::direction_off(&mut rng, axis, off_axis) * (1.0 + 9.0 * rng.f64());
            let exact = oracle::falloff(falloff, oracle::versine_between(way, axis), outer);
            (oracle::falloff(falloff, versine(way, axis), outer) - exact).abs()
        })
        .fold(0.0, f64::max)
}

/// A direction stored with `bits` fraction bits a component.
fn stored(bits: i32) -> impl Fn(DVec3) -> DVec3 {
    move |way| way.normalize().map(|c| rounded(c, bits))
}

/// An offset scaled to `way_bits` bits in its largest component, times a reciprocal rounded so that
/// every product fits 32 bits: what the kernel does, for a choice of the split.
fn split(way_bits: i32, reciprocal_bits: i32) -> impl Fn(DVec3) -> DVec3 {
    move |way| {
        let scale = 2.0_f64.powi(way_bits - 1 - way.abs().max_element().log2().floor() as i32);
        let way = (way * scale).round();
        // At most 2^reciprocal_bits, for the shortest scaled offset.
        let one = 2.0_f64.powi(way_bits - 1 + reciprocal_bits);
        let reciprocal = (one / way.length()).round() / one;
        reciprocal * way
    }
}

/// A direction stored in the 14 fraction bits of a scalar loses a hard edge of 3 degrees and either
/// edge of 1: it must be wider than a scalar.
#[test]
fn a_direction_needs_more_bits_than_a_scalar() {
    let columns: [(&str, oracle::Falloff, f64); 4] = [
        ("soft 3 deg", oracle::soft, 3.0),
        ("hard 3 deg", oracle::hard, 3.0),
        ("soft 1 deg", oracle::soft, 1.0),
        ("hard 1 deg", oracle::hard, 1.0),
    ];
    println!("largest error with a direction of so many fraction bits (half a step is {HALF_A_STEP:.2e})");
    println!("bits  {}", columns.map(|(name, ..)| name).join("  "));
    let errors = [14, 15, 16, 18, 30].map(|bits| {
        let errors = columns.map(|(_, falloff, degrees)| difference_error(&stored(bits), falloff, degrees));
        println!("{bits:4}  {}", errors.map(|error| format!("{error:10.1e}")).join("  "));
        errors
    });
    let [fourteen, .., thirty] = errors;
    assert!(fourteen[1..].iter().all(|&error| error > HALF_A_STEP), "14 bits would have done");
    assert!(thirty.iter().all(|&error| error < 1e-3 * HALF_A_STEP));
}

/// Within a 32-bit product the offset and the reciprocal of its length share 31 bits. An error of
/// the offset turns the direction, and a narrow cone magnifies it; an error of the reciprocal only
/// changes the length. So the offset gets more bits.
#[test]
fn the_offset_gets_the_larger_half_of_the_product() {
    println!("largest error with offset and reciprocal of so many bits");
    println!("bits     soft 1 deg  hard 3 deg  soft 30 deg  hard 30 deg");
    let errors = [(14, 17), (15, 16), (16, 15), (17, 14), (18, 13)].map(|(way, reciprocal)| {
        let normalise = split(way, reciprocal);
        let errors = [
            difference_error(&normalise, oracle::soft, 1.0),
            difference_error(&normalise, oracle::hard, 3.0),
            difference_error(&normalise, oracle::soft, 30.0),
            difference_error(&normalise, oracle::hard, 30.0),
        ];
        println!("{way} + {reciprocal}  {}", errors.map(|error| format!("{error:10.1e}")).join("  "));
        errors
    });
    let [_, _, sixteen, seventeen, eighteen] = errors;
    assert!(seventeen[0] < 0.6 * sixteen[0], "the seventeenth bit is not worth it");
    assert!(seventeen[3] < 1.2 * sixteen[3], "wide cones pay for the narrow ones");
    assert!(eighteen[3] > 1.7 * seventeen[3], "an eighteenth bit would have cost nothing");
}

/// A reciprocal of the outer versine in a fixed Q format saturates or loses its bits; a mantissa
/// with a shift does not.
#[test]
fn a_reciprocal_is_a_mantissa_and_a_shift() {
    println!("largest error of the soft falloff with the reciprocal of the outer versine in a format");
    println!("half angle  I16F16   I8F24    16-bit mantissa and shift");
    for degrees in [30.0, 5.0, 1.0, 0.1] {
        let outer = oracle::versine(degrees);
        let with = |reciprocal: f64| {
            (0..=1000)
                .map(|i| {
                    let versine = outer * f64::from(i) / 1000.0;
                    let t = ((outer - versine) * reciprocal).clamp(0.0, 1.0);
                    (t * t - oracle::falloff(oracle::soft, versine, outer)).abs()
                })
                .fold(0.0, f64::max)
        };
        let i16f16 = with(rounded(1.0 / outer, 16).min(32_768.0));
        let i8f24 = with(rounded(1.0 / outer, 24).min(128.0));
        let shift = 15 - (1.0 / outer).log2().floor() as i32;
        let mantissa = with(rounded(1.0 / outer, shift));
        println!("{degrees:10}  {i16f16:.1e}  {i8f24:.1e}  {mantissa:.1e}");
        assert!(mantissa < 4e-5);
        assert!(degrees > 4.0 || i8f24 > 0.9, "I8F24 would have done at {degrees} degrees");
        assert!(degrees > 0.2 || i16f16 > 0.9, "I16F16 would have done at {degrees} degrees");
    }
}

/// The angular resolution of lengths at a distance of 1: their quantum limits any method.
#[test]
fn a_length_has_a_quantum() {
    println!(
        "narrowest half angle for which a length's own rounding, at a distance of 1, stays under half a step"
    );
    for (name, bits) in [("I8F8", 8), ("I16F16", 16), ("I8F24", 24)] {
        let radians = 2.0_f64.powi(-bits - 1);
        let soft = radians * 1.5396 * 510.0;
        println!("{name:7} soft {:.4} degrees", soft.to_degrees());
    }
    let narrowest = (2.0_f64.powi(-17) * 1.5396 * 510.0).to_degrees();
    assert!((0.3..0.4).contains(&narrowest), "I16F16 holds a soft {narrowest} degrees at a distance of 1");
}
