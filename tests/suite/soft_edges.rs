//! Cones with a soft edge for both angles of a data sheet, against a search in f64.

use luminaire::{
    Angle, Cone, Fx16, Fx32,
    error::{Expected, Parameter},
    falloff::{AnyFalloff, Falloff, Soft, SoftEdged, SoftPair},
};
use support::{
    assert_that,
    format::Format,
    oracle::{self, half_degrees},
};

fn soft(beam: f32, field: f32) -> Result<Cone<SoftEdged>, luminaire::Error> {
    Cone::soft_from_beam_and_field(Angle::degrees(beam), Angle::degrees(field))
}

/// The versine of half an angle.
fn versine(degrees: f32) -> f64 {
    oracle::versine(f64::from(degrees) / 2.0)
}

/// The two soft falloffs of a cone with an outer versine, from the versines of both angles: the share of the narrow one,
/// and the `t` at which it begins. `None` if there are none.
fn pair_of(outer: f64, [beam, field]: [f64; 2]) -> Option<[f64; 2]> {
    let [beam, field] = [1.0 - beam / outer, 1.0 - field / outer];
    let share = 1.0 - 1.0 / (10.0 * field * field);
    let narrow = ((0.5 - beam * beam / (10.0 * field * field)) / share).sqrt();
    let begin = (beam - narrow) / (1.0 - narrow);
    (field > 0.0 && share > 0.0 && begin >= field && begin < beam).then_some([share, begin])
}

fn slope([share, begin]: [f64; 2]) -> f64 {
    2.0 * share / (1.0 - begin) + 2.0 * (1.0 - share)
}

/// The outer versines at which the wide falloff alone is 1/2 at the beam angle, and up to which a pair is looked for.
fn outers([beam, field]: [f64; 2]) -> [f64; 2] {
    let least = (5_f64.sqrt() * field - beam) / (5_f64.sqrt() - 1.0);
    [least, (1.7 * least).min(1.0)]
}

/// The pair with the least slope on the axis, of all outer angles up to 180 degrees.
fn best(versines: [f64; 2]) -> Option<[f64; 2]> {
    let [least, most] = outers(versines);
    let outer = |step: u32| least + (most - least) * f64::from(step) / 20_000.0;
    let pairs = (0..=20_000).filter_map(|step| pair_of(outer(step), versines));
    pairs.min_by(|a, b| slope(*a).total_cmp(&slope(*b)))
}

/// The share and the ratio of the narrow falloff, the outer angle, the least that is possible, and that of the cone with a
/// fitted falloff, of published pairs of angles.
#[test]
fn the_pairs_of_data_sheets() {
    for [beam, field, share, ratio, outer, least, fitted] in [
        [12.0_f32, 22.0, 0.333, 3.26, 28.13, 27.57, 23.03],
        [7.0, 15.0, 0.439, 4.73, 19.75, 19.17, 15.75],
        [26.0, 44.0, 0.230, 2.65, 55.21, 54.50, 46.02],
        [10.0, 23.0, 0.468, 5.55, 30.60, 29.63, 24.22],
    ] {
        let cone = soft(beam, field).expect("reachable");
        let SoftEdged::SoftPair(pair) = cone.falloff() else { panic!("{cone:?}") };
        assert_that!((pair.share() - share).abs() < 6e-4 && (pair.ratio() - ratio).abs() < 6e-3, pair);
        let other =
            Cone::from_beam_and_field(Angle::degrees(beam), Angle::degrees(field)).expect("reachable");
        let narrowest = 2.0 * half_degrees(outers([beam, field].map(versine))[0]);
        let found = [cone.outer().to_degrees(), narrowest as f32, other.outer().to_degrees()];
        let expected = [outer, least, fitted];
        assert!(
            found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 6e-3),
            "{found:?}"
        );
    }
}

/// Random pairs of angles of the whole domain have both angles in every format, no edge, and of all soft pairs the
/// least slope; or they are refused, with a range of field angles that is accepted and ends where it must.
#[test]
fn every_pair_of_angles_has_a_soft_edge() {
    let mut rng = fastrand::Rng::with_seed(63);
    let (mut kinds, mut worst) = ([0; 4], 0.0_f64);
    for _ in 0..10_000 {
        let beam = 180.0 * (-10.0 * rng.f32() * rng.f32()).exp2();
        let field = beam + (180.0 - beam) * rng.f32().powi(1 + 2 * i32::from(rng.u8(..3)));
        let versines = [beam, field].map(versine);
        let ratio = versines[1] / versines[0];
        let cone = match soft(beam, field) {
            Ok(cone) => cone,
            Err(refused) => {
                let Expected::AngleBetween(least, most) = refused.accepted else { panic!("{refused}") };
                assert_eq!((refused.parameter, least), (Parameter::FieldAngle, beam), "{refused}");
                assert!(
                    soft(beam, (most * 0.999_99).max(least)).is_ok() && most < field * 1.000_01,
                    "{refused}"
                );
                if ratio > 2.3346 {
                    let is_too_wide = outers(versines)[0] > 0.999_99;
                    let is_too_narrow =
                        || best(versines).is_none_or(|[_, begin]| 1.0 - begin < 1.0 / 1_023.0);
                    assert!(is_too_wide || is_too_narrow(), "{beam} {field}: {refused}");
                }
                kinds[3] += 1;
                continue;
            }
        };
        let near = |angle: Angle, asked: f32| (angle.to_degrees() / asked - 1.0).abs() < 4e-6;
        assert!(near(cone.beam(), beam) && near(cone.field(), field), "{beam} {field}: {cone:?}");
        for (asked, intensity) in [(beam, 0.5), (field, 0.1)] {
            assert_has::<f32>(&cone, asked, intensity);
            assert_has::<Fx32>(&cone, asked, intensity);
            assert_has::<Fx16>(&cone, asked, intensity);
        }
        let kind = match cone.falloff() {
            _ if cone.inner().to_degrees() > 0.0 => 0,
            SoftEdged::Cubic(cubic) => {
                assert_eq!(cubic.edge_slope(), 0.0, "{beam} {field}");
                1
            }
            SoftEdged::SoftPair(pair) => {
                let best = best(versines).map(slope).expect("a pair");
                let found = slope([pair.share(), 1.0 - 1.0 / pair.ratio()].map(f64::from));
                worst = worst.max(found / best - 1.0);
                2
            }
        };
        kinds[kind] += 1;
    }
    assert!(kinds.iter().all(|&count| count > 300), "{kinds:?}");
    assert!((1e-6..=3e-5).contains(&worst), "a slope of {worst} over the least");
}

/// In f64, the closed form with a `w` of 0.404 at the beam angle has nearly the least slope that is possible, for ratios up
/// to 2,000.
#[test]
fn the_closed_form_is_nearly_the_best() {
    let mut worst = 0.0_f64;
    for step in 0..=200 {
        let ratio = 2.35 * (2_000.0_f64 / 2.35).powf(f64::from(step) / 200.0);
        let (versines, narrow, inverse) = ([1e-6, 1e-6 * ratio], 0.404_f64.powi(2), 1.0 / ratio);
        let factor = 5.0 - 10.0 * narrow;
        let (a, b, c) = (factor - inverse * inverse, factor - inverse, factor - 1.0 + narrow);
        let x = c / (b + (b * b - a * c).sqrt());
        let [found, best] = [pair_of(versines[1] / x, versines), best(versines)].map(|pair| pair.map(slope));
        worst = worst.max(found.expect("a pair") / best.expect("a pair") - 1.0);
    }
    println!("a slope of {worst:.1e} over the least");
    assert!((5e-6..=1e-5).contains(&worst), "{worst:e}");
}

/// A format that holds the cone has an intensity at an angle.
fn assert_has<S: Format>(cone: &Cone<SoftEdged>, degrees: f32, intensity: f64) {
    let Ok(falloff) = cone.compile::<S>() else { return };
    let hotspot = cone.inner().versine() / cone.outer_versine();
    // The angles of an edge this steep are rounded to more than its width.
    if hotspot > 0.999 {
        return;
    }
    let steepness = cone.falloff().steepness(hotspot);
    let found = falloff.at(falloff.versine(versine(degrees) as f32)).exact();
    // In 16 bits half a code, for which a steep cone is held.
    let within = 32.2 * f64::from(S::STEP) + 2e-6 * f64::from(steepness);
    assert_that!((found - intensity).abs() < within, S::NAME, cone, found, intensity);
}

/// No soft pair rises towards its edge, and its derivative there is 0.
#[test]
fn a_soft_pair_fades_out() {
    let mut rng = fastrand::Rng::with_seed(9);
    for _ in 0..2_000 {
        let share = [0.0, 1.0, rng.f32()][usize::from(rng.u8(..3))];
        let ratio = [1.0, 1_024.0, (10.0 * rng.f32()).exp2()][usize::from(rng.u8(..3))];
        let pair = SoftPair::new(share, ratio).expect("sound");
        let exact = |t: f64| pair.formula().exact(t);
        let values = (0..=1_000).map(|i| exact(f64::from(i) / 1_000.0));
        assert!(values.is_sorted(), "{pair:?}");
        assert_that!(exact(1e-6) <= 1.000_1e-12, pair);
        assert_that!((exact(1.0) - 1.0).abs() < 1e-15, pair);
    }
}

/// At the ratio of the soft quadratic all three kinds that meet there are the soft quadratic.
#[test]
fn soft_is_between_cubics_and_pairs() {
    let field = Cone::from_beam(Soft, Angle::degrees(10.0)).expect("sound").field().to_degrees();
    for factor in [0.999_999, 1.000_001] {
        let cone = soft(10.0, field * factor).expect("reachable");
        for t in [0.1, 0.3, 0.7, 0.9] {
            assert_that!((cone.falloff().formula().exact(t) - t * t).abs() < 2e-4, cone, t);
        }
    }
    let step = soft(10.0, 10.0).expect("a step");
    assert_eq!(step.inner(), step.outer());
}

/// In a wide beam a hard edge has field angles that no soft edge has.
#[test]
fn a_beam_that_is_too_wide_is_refused() {
    let hard = Cone::from_beam_and_field(Angle::degrees(110.0), Angle::degrees(155.0)).expect("a hard cone");
    let refused = soft(110.0, 155.0).expect_err("an outer angle over 180 degrees");
    assert_eq!(refused.to_string(), "field angle = 155: expected 110 to 153.7708 degrees (full angle)");
    assert!(hard.outer().to_degrees() < 180.0);
    for beam in [0.0, -7.0, f32::NAN, 180.0_f32.next_up(), f32::INFINITY] {
        assert_eq!(soft(beam, 15.0).expect_err("no beam").parameter, Parameter::BeamAngle);
    }
    for field in [0.0, f32::NAN, 6.9, 181.0, f32::INFINITY] {
        assert_eq!(soft(7.0, field).expect_err("no field").parameter, Parameter::FieldAngle);
    }
    assert!(matches!(
        AnyFalloff::from(soft(7.0, 15.0).expect("reachable").falloff()),
        AnyFalloff::SoftPair(_)
    ));
}
