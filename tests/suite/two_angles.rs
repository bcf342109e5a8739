//! Cones with both angles of a data sheet, against a search over all monotone cubics in f64.

use luminaire::{
    Angle, Cone, Error, Fx16, Fx32,
    error::{Expected, Parameter},
    falloff::{Cubic, Falloff, FittedFalloff},
};
use support::{
    assert_that, cubics,
    format::Format,
    oracle::{self, half_degrees},
};

/// The full angle in degrees whose half has this versine.
fn full(versine: f64) -> f64 {
    2.0 * half_degrees(versine)
}

/// The field angle for which the versines have this ratio to those of a beam angle, both in
/// degrees.
fn field_of(beam: f32, ratio: f64) -> f32 {
    full(ratio * oracle::versine(f64::from(beam) / 2.0)) as f32
}

fn degrees(degrees: f32) -> Angle {
    Angle::degrees(degrees)
}

/// The cone has the two given angles, by its getters and by the falloff itself.
fn assert_both<S: Format, P: Falloff>(cone: &Cone<P>, beam: f32, field: f32) {
    assert_both_within::<S, P>(cone, beam, field, 4e-6);
}

/// As above, with the angles within a relative error.
fn assert_both_within<S: Format, P: Falloff>(cone: &Cone<P>, beam: f32, field: f32, error: f32) {
    let near = |angle: Angle, asked: f32| (angle.to_degrees() / asked - 1.0).abs() < error;
    assert!(near(cone.beam(), beam), "{cone:?}: beam {} for {beam}", cone.beam().to_degrees());
    assert!(near(cone.field(), field), "{cone:?}: field {} for {field}", cone.field().to_degrees());
    let falloff = cone.compile::<S>().expect("held");
    // A steep edge around a wide hotspot magnifies the f32 rounding of an angle.
    let within = 4.0 * f64::from(S::STEP) + 2e-6 * f64::from(steepness(cone));
    for (asked, intensity) in [(beam, 0.5), (field, 0.1)] {
        let versine = oracle::versine(f64::from(asked) / 2.0) as f32;
        let found = falloff.at(falloff.versine(versine)).exact();
        assert_that!((found - intensity).abs() < within, S::NAME, cone, found, asked);
    }
}

fn steepness<P: Falloff>(cone: &Cone<P>) -> f32 {
    let hotspot = cone.inner().versine() / cone.outer_versine();
    if hotspot < 1.0 { cone.falloff().steepness(hotspot) } else { 1.0 }
}

#[test]
fn the_papers_fresnel_has_both_its_angles() {
    let cone = Cone::from_beam_and_field(degrees(7.0), degrees(15.0)).expect("reachable");
    assert!(matches!(cone.falloff(), FittedFalloff::Cubic(_)));
    assert_both::<f32, _>(&cone, 7.0, 15.0);
    assert_both::<Fx32, _>(&cone, 7.0, 15.0);
    assert_both::<Fx16, _>(&cone, 7.0, 15.0);
    let (least, most) = Cone::edge_slopes(degrees(7.0), degrees(15.0)).expect("reachable");
    assert_that!((least - 0.89).abs() < 0.01 && (most - 2.27).abs() < 0.01, least, most);
}

/// Every ratio from 1.01 to the largest, with narrow and with wide beams, gives a cone with both
/// angles.
#[test]
fn every_ratio_is_reached() {
    let mut kinds = [0; 3];
    for beam in [0.5, 7.0, 20.0, 60.0] {
        for step in 0..=880 {
            let ratio = 1.01 + 0.005 * f64::from(step);
            // An edge so steep in a cone so narrow is refused, because f32 does not hold it.
            if beam < 1.0 && ratio < 1.02 {
                continue;
            }
            if ratio > 5.437 || ratio * oracle::versine(f64::from(beam) / 2.0) > 0.6 {
                break;
            }
            let field = field_of(beam, ratio);
            let cone = Cone::from_beam_and_field(degrees(beam), degrees(field)).expect("reachable");
            assert_both::<f32, _>(&cone, beam, field);
            let kind = match cone.falloff() {
                _ if cone.inner().to_degrees() > 0.0 => 0,
                FittedFalloff::Quadratic(_) => 1,
                FittedFalloff::Cubic(_) => 2,
            };
            let expected = if ratio < 1.3416 { 0 } else { 1 + usize::from(ratio > 2.33456) };
            let between = (ratio - 1.3416).abs() < 1e-4 || (ratio - 2.33455).abs() < 1e-4;
            assert!(kind == expected || between, "{ratio}: {cone:?}, expected kind == expected or between");
            kinds[kind] += 1;
        }
    }
    assert!(kinds.iter().all(|&count| count > 100), "cones of each kind: {kinds:?}, expected over 100");
}

/// Special ratios: those of soft and hard give soft and hard, and equal angles give a step. Near
/// soft, the edge slope is proportional to the root of the ratio's difference from that of soft, so
/// f32 finds the slope to three digits only.
#[test]
fn the_ends_of_the_ratios_are_soft_hard_and_a_step() {
    let slope = |field| match Cone::from_beam_and_field(degrees(10.0), degrees(field)).expect("ok").falloff()
    {
        FittedFalloff::Quadratic(quadratic) => quadratic.edge_slope(),
        FittedFalloff::Cubic(cubic) => panic!("{cubic:?}"),
    };
    let field = |falloff: &dyn Fn() -> Angle| falloff().to_degrees();
    let soft = field(&|| Cone::from_beam(luminaire::falloff::Soft, degrees(10.0)).expect("sound").field());
    let hard = field(&|| Cone::from_beam(luminaire::falloff::Hard, degrees(10.0)).expect("sound").field());
    assert!(slope(soft * 0.999_999) < 1e-2 && slope(hard * 1.000_001) > 1.999);
    for ulps in 0..400 {
        let near_hard =
            Cone::from_beam_and_field(degrees(10.0), degrees(f32::from_bits(hard.to_bits() + 200 - ulps)));
        let near_hard = near_hard.expect("sound");
        assert_that!(near_hard.inner().to_degrees() >= 0.0, near_hard);
        let FittedFalloff::Quadratic(quadratic) = near_hard.falloff() else { panic!("{near_hard:?}") };
        assert_that!((1.99..=2.0).contains(&quadratic.edge_slope()), quadratic);
    }
    let step = Cone::from_beam_and_field(degrees(10.0), degrees(10.0)).expect("a step");
    assert_eq!(step.inner(), step.outer());
    for half in [4.999, 5.001_f32] {
        let falloff = step.compile::<Fx16>().expect("held");
        let intensity = falloff.at(falloff.versine(oracle::versine(half.into()) as f32));
        assert_eq!(intensity.exact(), f64::from(u8::from(half < 5.0)));
    }
}

/// The feasible region as in the documentation: the smallest and the largest ratio for each edge
/// slope.
#[test]
fn the_feasible_region_is_the_documented_one() {
    let documented = [
        (0.0, 1.608, 2.597),
        (0.5, 1.587, 3.258),
        (1.0, 1.521, 5.115),
        (1.5, 1.430, 5.403),
        (2.0, 1.342, 4.982),
        (2.5, 1.270, 4.154),
        (3.0, 1.216, 1.928),
    ];
    for (edge, least, most) in documented {
        let (found_least, found_most) = cubics::ratios(edge, 8_000).expect("there are cubics");
        assert!((found_least - least).abs() < 1e-3, "{edge}: smallest {found_least}");
        assert!((found_most - most).abs() < 5e-3, "{edge}: largest {found_most}");
    }
    let all =
        (0..=200).filter_map(|i| Some((f64::from(i) / 50.0, cubics::ratios(f64::from(i) / 50.0, 2_000)?)));
    let (farthest, most) =
        all.clone().map(|(a, (_, most))| (a, most)).fold((0.0, 0.0), |x, y| if y.1 > x.1 { y } else { x });
    let least = all.map(|(_, (least, _))| least).fold(f64::INFINITY, f64::min);
    assert_that!((most - 5.437).abs() < 2e-3 && (farthest - 1.34).abs() < 0.02, most, farthest);
    assert_that!((least - 1.1585).abs() < 5e-4, least);
}

/// For each edge slope the kernel reaches the ratios that the search finds, up to both ends.
#[test]
fn the_ratios_of_an_edge_slope_are_what_the_search_finds() {
    let reaches = |edge: f32, ratio: f64| {
        let field = degrees(field_of(7.0, ratio));
        Cone::from_beam_field_and_slope(degrees(7.0), field, edge).is_ok()
    };
    for edge in [0.0_f32, 0.5, 1.0, 1.34, 2.0, 2.5, 2.75] {
        let (least, most) = cubics::ratios(edge.into(), 8_000).expect("there are cubics");
        for (end, beyond) in [(least, least - 0.003), (most, most + 0.003)] {
            let within = end + (end - beyond);
            assert!(reaches(edge, within) && !reaches(edge, beyond), "{edge}: {within} and {beyond}");
        }
    }
}

/// For an edge slope of choice the cubic has both angles, is monotone, and of the two that share
/// them it is the one whose smallest slope is larger.
#[test]
fn of_two_cubics_the_one_without_a_ring_is_taken() {
    let mut shared = 0;
    for ratio in [1.3, 1.62, 2.0, 2.62, 2.7, 2.8, 3.0, 3.2, 4.0, 4.587, 5.3] {
        let field = field_of(7.0, ratio);
        let (least, most) = Cone::edge_slopes(degrees(7.0), degrees(field)).expect("reachable");
        for i in 0..=16 {
            let edge = (least + (most - least) * i as f32 / 16.0).clamp(least, most);
            let cone = Cone::from_beam_field_and_slope(degrees(7.0), degrees(field), edge).expect("feasible");
            // At an end of the interval the curve may have slope zero just where the intensity is a
            // half, so that f32 finds the angle less precisely.
            let error = if i % 16 == 0 { 5e-5 } else { 4e-6 };
            assert_both_within::<f32, _>(&cone, 7.0, field, error);
            let [a, b, c] = cone.falloff().coefficients().map(f64::from);
            assert_eq!(a + b + c, 1.0);
            let taken = cubics::Cubic { a, b, c };
            assert_that!(taken.smallest_slope() > -1e-5, taken);
            let cubics: Vec<_> =
                cubics::of_edge_slope(a, 1_500).map(|cubic| (cubic, cubic.ratio())).collect();
            let crossings = cubics.windows(2).filter(|pair| (pair[0].1 > ratio) != (pair[1].1 > ratio));
            let sharing: Vec<_> = crossings.map(|pair| pair[0].0.smallest_slope()).collect();
            let best = sharing.iter().copied().fold(0.0, f64::max);
            shared += usize::from(sharing.iter().any(|slope| best - slope > 0.05));
            assert_that!(taken.smallest_slope() > best - 0.02, ratio, edge, taken.smallest_slope(), best);
        }
    }
    assert!(shared > 5, "only {shared} cases had two cubics");
}

/// Beyond the last ratio the error names the widest field angle for the beam angle, and that one is
/// accepted.
#[test]
fn an_unreachable_pair_names_the_nearest() {
    for (beam, field) in [(7.0, 18.0), (7.0, 6.0), (40.0, 179.0), (120.0, 179.0), (0.5, 9.0)] {
        let refused = Cone::from_beam_and_field(degrees(beam), degrees(field)).expect_err("out of reach");
        assert_eq!((refused.parameter, refused.value), (Parameter::FieldAngle, field));
        let Expected::AngleBetween(least, most) = refused.accepted else { panic!("{refused}") };
        assert_eq!(least, beam);
        for shown in [least, most * 0.999_99] {
            let cone = Cone::from_beam_and_field(degrees(beam), degrees(shown)).expect("a named angle");
            assert_that!(cone.outer().to_degrees() <= 180.0, beam, shown, cone);
        }
        assert!(Cone::from_beam_and_field(degrees(beam), degrees(most * 1.000_1)).is_err());
    }
    let widest = |i: u16| Cone::from_beam_and_field(degrees(120.0), degrees(120.0 + f32::from(i) / 100.0));
    assert!((0..=6_000).filter_map(|i| widest(i).ok()).all(|cone| cone.outer_versine() <= 1.0));
    let refused = Cone::from_beam_and_field(degrees(7.0), degrees(18.0)).expect_err("out of reach");
    assert_eq!(refused.to_string(), "field angle = 18: expected 7 to 16.3334 degrees (full angle)");
}

/// With an edge slope of choice a field angle near the beam angle is out of reach, too: the error
/// names the nearest on both sides.
#[test]
fn an_unreachable_ratio_of_a_cubic_names_the_nearest() {
    for (beam, field) in [(7.0, 7.1), (40.0, 40.0), (7.0, 18.0)] {
        let refused = Cone::edge_slopes(degrees(beam), degrees(field)).expect_err("out of reach");
        let Expected::AngleBetween(least, most) = refused.accepted else { panic!("{refused}") };
        assert_that!(beam < least && least < most, refused);
        for (end, beyond) in [(least, 0.999_99), (most, 1.000_01)] {
            let within = Cone::edge_slopes(degrees(beam), degrees(end * (2.0 - beyond)));
            assert!(within.is_ok(), "{beam} {end}: {within:?}");
            assert!(Cone::edge_slopes(degrees(beam), degrees(end * beyond)).is_err(), "{beam} {end}");
        }
    }
}

#[test]
fn what_is_no_angle_is_refused_by_name() {
    for beam in [0.0, -7.0, f32::NAN, 180.0_f32.next_up(), 181.0, f32::INFINITY] {
        let refused = Cone::from_beam_and_field(degrees(beam), degrees(15.0)).expect_err("no beam");
        assert_eq!(refused.parameter, Parameter::BeamAngle, "{refused}");
    }
    for field in [0.0, f32::NAN, 181.0, f32::INFINITY] {
        let refused = Cone::from_beam_and_field(degrees(7.0), degrees(field)).expect_err("no field");
        assert_eq!(refused.parameter, Parameter::FieldAngle, "{refused}");
    }
    for slope in [0.8, 2.4, f32::NAN] {
        let refused: Result<Cone<Cubic>, Error> =
            Cone::from_beam_field_and_slope(degrees(7.0), degrees(15.0), slope);
        let refused = refused.expect_err("no such slope");
        assert_eq!(refused.parameter, Parameter::EdgeSlope, "{refused}");
    }
}

#[test]
fn half_a_turn_is_an_angle() {
    let half_a_turn = Angle::degrees(180.0);
    let step = Cone::from_beam_and_field(half_a_turn, half_a_turn).expect("a step at the widest outer angle");
    assert_eq!(step.outer().to_degrees(), 180.0);
    assert!(Cone::edge_slopes(Angle::degrees(140.0), half_a_turn).is_ok());
    let wider = Angle::degrees(180.0_f32.next_up());
    assert!(Cone::from_beam_and_field(wider, wider).is_err());
    assert!(Cone::edge_slopes(Angle::degrees(140.0), wider).is_err());
}
