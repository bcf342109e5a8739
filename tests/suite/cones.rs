//! The properties of a cone: its hotspot and cutoff, what it refuses, and the figures of the paper.

use luminaire::{
    Angle, Cone, Error, Fx16, Fx32, HalfAngle,
    error::{Expected, Parameter},
    falloff::{
        Cubic, Falloff, Hard, IntegerPower, Knot, Linear, Power, Quadratic, Smooth, Soft, Step, Table,
    },
};
use support::{assert_that, format::Format, in_every_format, oracle};

fn assert_near(what: &str, found: f32, expected: f64, within: f64) {
    assert!((f64::from(found) / expected - 1.0).abs() < within, "{what} is {found}, not {expected}");
}

/// The shares of the paper's falloffs: a third and two thirds of a full cone.
#[test]
fn soft_has_a_third_of_the_flux_and_hard_two() {
    let full = Cone::from_outer(Step, Angle::degrees(30.0)).expect("sound").lumens(1.0);
    let soft = Cone::from_outer(Soft, Angle::degrees(30.0)).expect("sound").lumens(1.0);
    let hard = Cone::from_outer(Hard, Angle::degrees(30.0)).expect("sound").lumens(1.0);
    assert_near("soft", soft / full, 1.0 / 3.0, 1e-6);
    assert_near("hard", hard / full, 2.0 / 3.0, 1e-6);
}

/// A table may begin below full intensity; its hotspot has the first value, as its evaluation has.
#[test]
fn a_dim_hotspot_has_its_own_flux() {
    let table = Table::new(&[16_384, 65_535, 0]).expect("enough samples");
    let cone =
        Cone::from_outer(table, Angle::degrees(40.0)).and_then(|cone| cone.with_inner(Angle::degrees(30.0)));
    let cone = cone.expect("sound");
    let [inner, outer, _] = cone.versines().map(f64::from);
    // A quarter in the hotspot; the ramp's two lines have means of 5/8 and 1/2.
    let exact = std::f64::consts::TAU * (inner / 4.0 + (outer - inner) * (5.0 / 8.0 + 1.0 / 2.0) / 2.0);
    assert_near("the flux", cone.lumens(1.0), exact, 2e-5);
    let cut = cone.with_cutoff(Angle::degrees(20.0)).expect("sound");
    let exact = std::f64::consts::TAU * f64::from(cut.outer_versine()) / 4.0;
    assert_near("the flux of a part of the hotspot", cut.lumens(1.0), exact, 2e-5);
}

/// A ramp of a few ULP is a step: it is held like one, whatever its falloff.
#[test]
fn a_ramp_of_a_few_ulp_is_a_step() {
    let outer = Angle::degrees(15.0);
    for less in 0..40 {
        let inner = Angle::degrees(f32::from_bits(15.0_f32.to_bits() - less));
        let cone = Cone::from_outer(Smooth, outer).and_then(|cone| cone.with_inner(inner)).expect("sound");
        let [inner, outer, _] = cone.versines();
        let is_step = inner >= (1.0 - 1.0 / 1_048_576.0) * outer;
        assert_eq!(cone.compile::<Fx16>().is_ok(), is_step, "{less}");
    }
}

/// A cutoff removes the light outside it and leaves the rest bit-identical. If it is narrower than
/// the beam angle, all three angles equal the cutoff.
#[test]
fn a_cutoff_changes_nothing_within() {
    let cone = Cone::from_field(Soft, Angle::degrees(30.0)).expect("sound");
    let cut = cone.with_cutoff(Angle::degrees(12.0)).expect("tighter");
    in_every_format!(assert_cut(&cone, &cut));
    assert_eq!((cut.beam(), cut.field()), (cut.outer(), cut.outer()));
    assert_near("outer", cut.outer().to_degrees(), 12.0, 1e-6);
}

/// Within a cutoff of 12 degrees the intensity is the same, with each versine in the scale of its
/// own cone; outside it is zero. `Fx32` has more bits than the versine of the open cone, which it
/// rounds by up to 3 steps.
fn assert_cut<S: Format>(open: &Cone<Soft>, cut: &Cone<Soft>) {
    let (open, cut) = (open.compile::<S>().expect("held"), cut.compile::<S>().expect("held"));
    for millidegrees in 0..20_000_u16 {
        let half = f32::from(millidegrees) / 1e3;
        let versine = Angle::from(HalfAngle::degrees(half)).versine();
        let expected = if half < 6.0 { open.at(open.versine(versine)) } else { S::ZERO };
        let found = cut.at(cut.versine(versine));
        let steps = if S::NAME == "fx32" && half < 6.0 { 3.0 } else { 0.0 };
        let apart = (found.exact() - expected.exact()).abs() / f64::from(S::STEP);
        assert!(apart <= steps, "{} {half}: {found:?}, not {expected:?}", S::NAME);
    }
}

/// An inner angle equal to the outer one makes a step, with every falloff and format.
#[test]
fn inner_at_outer_is_a_step() {
    fn assert_step<S: Format, P: Falloff>(falloff: P) {
        let angle = Angle::degrees(40.0);
        let cone = Cone::from_outer(falloff, angle).and_then(|cone| cone.with_inner(angle)).expect("sound");
        let falloff = cone.compile::<S>().expect("held");
        let outer = cone.outer_versine();
        assert_eq!(falloff.at(falloff.versine(outer.next_down())), S::ONE, "{falloff:?}");
        assert_eq!(falloff.at(falloff.versine(outer)), S::ZERO, "{falloff:?}");
        assert_eq!((cone.inner(), cone.beam(), cone.field()), (cone.outer(), cone.outer(), cone.outer()));
    }
    assert_step::<f32, _>(Soft);
    assert_step::<Fx32, _>(Smooth);
    assert_step::<Fx16, _>(Hard);
    assert_step::<Fx16, _>(Power::<8>);
}

fn assert_refused<T: core::fmt::Debug>(result: Result<T, Error>, parameter: Parameter, remedy: &str) {
    let error = result.expect_err(remedy);
    assert_eq!(error.parameter, parameter, "{error}");
    assert_that!(error.to_string().contains(remedy), error);
}

#[test]
fn hotspots_and_cutoffs_out_of_range_are_refused() {
    let cone = Cone::from_outer(Soft, Angle::degrees(30.0)).expect("sound");
    for inner in [-1.0, 30.1, 400.0, f32::NAN] {
        let refused = cone.with_inner(Angle::degrees(inner));
        assert_refused(refused, Parameter::InnerAngle, "expected 0 to ");
    }
    for cutoff in [0.0, -1.0, 30.1, 400.0, f32::NAN] {
        let refused = cone.with_cutoff(Angle::degrees(cutoff));
        assert_refused(refused, Parameter::CutoffAngle, "expected more than 0 and at most ");
    }
    for cutoff in [0.0, 91.0, f32::NAN] {
        let refused = Cone::<Power<8>>::opengl(HalfAngle::degrees(cutoff));
        assert_refused(refused, Parameter::CutoffAngle, "at most 180 degrees");
    }
}

/// A hotspot that makes the edge too steep for a format is refused, and the error names the largest
/// accepted one.
#[test]
fn a_hotspot_too_steep_for_its_format_is_refused() {
    let cone = Cone::from_outer(Linear, Angle::degrees(30.0)).expect("sound");
    let steep = cone.with_inner(Angle::degrees(29.9)).expect("sound");
    let error = steep.compile::<Fx16>().expect_err("too steep for 16 bits");
    assert_eq!(error.parameter, Parameter::InnerAngle);
    let Expected::AngleBetween(_, most) = error.accepted else { panic!("{error}") };
    let with = |inner: f32| cone.with_inner(Angle::degrees(inner)).expect("sound").compile::<Fx16>();
    assert!(with(most * 0.999_99).is_ok() && with(most * 1.000_1).is_err(), "{most}");
    assert!(steep.compile::<Fx32>().is_ok());
    let needle = cone.with_cutoff(Angle::degrees(0.1)).expect("sound");
    assert_refused(needle.compile::<Fx16>().map(drop), Parameter::CutoffAngle, "expected at least ");
}

#[test]
fn coefficients_out_of_range_are_refused() {
    for slope in [-f32::MIN_POSITIVE, -0.1, 2.0_f32.next_up(), 2.1, f32::NAN] {
        assert_refused(Quadratic::new(slope), Parameter::EdgeSlope, "from 0 to 2");
    }
    for slope in [-f32::MIN_POSITIVE, -0.1, 4.0_f32.next_up(), 4.1, f32::NAN] {
        assert_refused(Cubic::with_slopes(slope, 1.0), Parameter::EdgeSlope, "from 0 to 4");
    }
    // The ellipse of Fritsch and Carlson, at an edge slope of 1 and of 3.5.
    assert_refused(Cubic::with_slopes(1.0, 4.01), Parameter::MiddleSlope, "from 0 to 4");
    assert_refused(Cubic::with_slopes(3.5, 0.05), Parameter::MiddleSlope, "from 0.104");
    for slope in [3.1_f32, 3.5, 3.9] {
        let refused = Cubic::with_slopes(slope, 0.0).expect_err("no such middle slope");
        let Expected::Between(least, most) = refused.accepted else { panic!("{refused}") };
        // a^2 + a d + d^2 - 6 a - 6 d + 9 = 0
        let (a, root) = (f64::from(slope), |a: f64| (3.0 * a * (4.0 - a)).sqrt());
        let ends = [(6.0 - a - root(a)) / 2.0, (6.0 - a + root(a)) / 2.0];
        for (found, exact) in [least, most].into_iter().zip(ends) {
            assert!((f64::from(found) - exact).abs() < 2e-6, "{slope}: {found}, expected {exact}");
        }
    }
    let two = Cubic::new(1.0, 0.5, 0.5).expect_err("a sum of 2");
    assert_eq!((two.parameter, two.accepted), (Parameter::CoefficientSum, Expected::Exactly(1.0)));
    // A sum within 2^-20 of 1 counts as 1, and no other sum is accepted.
    for step in [-2.0_f32, 2.0] {
        let beside = step / 1_048_576.0;
        assert_refused(Cubic::new(1.0, 0.0, beside), Parameter::CoefficientSum, "expected 1");
        assert!(Cubic::new(1.0, 0.0, beside / 2.0).is_ok());
    }
    assert_refused(Cubic::new(f32::NAN, 0.5, 0.5), Parameter::CoefficientSum, "expected 1");
    assert_refused(Cubic::new(-0.5, 3.0, -1.5), Parameter::EdgeSlope, "from 0 to 4");
    assert_eq!(Cubic::new(0.7, 0.2, 0.1).expect("monotone").coefficients().iter().sum::<f32>(), 1.0);
    let smooth = Cubic::new(0.0, 3.0, -2.0).expect("monotone");
    assert_eq!(smooth.coefficients(), [0.0, 3.0, -2.0]);
}

#[test]
fn tables_out_of_range_are_refused() {
    assert_refused(Table::new(&[]), Parameter::SampleCount, "from 2 to 65536");
    assert_refused(Table::new(&[1]), Parameter::SampleCount, "from 2 to 65536");
    let count = |samples| Table::new(samples).map(|table| table.samples().len());
    assert_refused(count(&[1; 65_537]), Parameter::SampleCount, "from 2 to 65536");
    assert_eq!(count(&[1; 65_536]), Ok(65_536));
    let mut samples = [Knot::default(); 8];
    let outer = Angle::degrees(80.0);
    assert_refused(
        Table::from_angles(&[1.0, 0.0], outer, &mut []),
        Parameter::SampleCount,
        "from 1 to 65536",
    );
    assert_refused(Table::from_angles(&[1.0], outer, &mut samples), Parameter::SampleCount, "from 2");
    assert_refused(Table::from_angles(&[1.0, 1.1], outer, &mut samples), Parameter::Sample, "from 0 to 1");
    assert_refused(
        Table::from_angles(&[1.0, f32::NAN], outer, &mut samples),
        Parameter::Sample,
        "from 0 to 1",
    );
    let wide = Table::from_angles(&[1.0, 0.0], Angle::degrees(181.0), &mut samples);
    assert_refused(wide, Parameter::OuterAngle, "at most 180 degrees");
}

/// A table may end above zero, but the edge is dark.
#[test]
fn a_table_is_dark_from_its_edge_on() {
    let samples = [65_535, 50_000, 40_000];
    let table = Table::new(&samples).expect("sound");
    let cone = Cone::from_outer(table, Angle::degrees(60.0)).expect("sound");
    let falloff = cone.compile::<Fx32>().expect("held");
    let outer = cone.outer_versine();
    assert_eq!(falloff.at(falloff.versine(outer)), Fx32::ZERO);
    assert!(falloff.at(falloff.versine(outer.next_down())).to_f32() > 0.6);
    assert_eq!(cone.beam(), cone.outer());
}

/// A cutoff within the hotspot leaves a step, of which both angles are the cutoff.
#[test]
fn a_cutoff_within_the_hotspot_is_the_inner_angle() {
    let cone = Cone::from_outer(Soft, Angle::degrees(30.0)).expect("sound");
    let cut = cone.with_inner(Angle::degrees(20.0)).and_then(|cone| cone.with_cutoff(Angle::degrees(10.0)));
    let cut = cut.expect("sound");
    assert_eq!(cut.inner(), cut.outer());
    assert!((cut.outer().to_degrees() - 10.0).abs() < 1e-5);
    assert!(cone.with_cutoff(Angle::degrees(1e-4)).is_ok());
    assert!(cone.with_cutoff(Angle::degrees(0.0)).is_err());
}

fn assert_degrees(what: &str, angle: Angle, expected: f32, within: f32) {
    let degrees = angle.to_degrees();
    assert!((degrees - expected).abs() <= within, "{what} is {degrees}, not {expected}");
}

#[test]
fn a_soft_field_angle_of_15_degrees_has_the_papers_beam_and_outer_angle() {
    let cone = Cone::from_field(Soft, Angle::degrees(15.0)).expect("a sound angle");
    assert_degrees("beam", cone.beam(), 9.81, 0.005);
    assert_degrees("outer", cone.outer(), 18.15, 0.005);
}

#[test]
fn a_hard_field_angle_of_15_degrees_has_the_papers_beam_and_outer_angle() {
    let cone = Cone::from_field(Hard, Angle::degrees(15.0)).expect("a sound angle");
    assert_degrees("beam", cone.beam(), 12.95, 0.005);
    assert_degrees("outer", cone.outer(), 15.40, 0.005);
}

/// Figure 7: the cosine power with the paper's field angle, and its intensity where the soft and
/// the hard edge have half their intensity.
#[test]
fn a_cosine_power_of_the_papers_field_angle_has_exponent_268() {
    let cone = Cone::<Power<268>>::opengl(HalfAngle::degrees(90.0)).expect("a sound cutoff");
    assert_degrees("field", cone.field(), 15.0, 5e-4);
    assert_degrees("beam", cone.beam(), 8.238, 5e-4);
    let run_time = Cone::from_outer(IntegerPower::new(268).expect("a sound exponent"), Angle::degrees(180.0));
    assert_eq!(run_time.expect("a sound angle").field(), cone.field());
    let compiled = cone.compile::<f32>().expect("f32 holds it");
    for degrees in [4.9_f64, 6.475, 7.5, 9.0] {
        let versine = compiled.versine(oracle::versine(degrees) as f32);
        let exact = degrees.to_radians().cos().powi(268);
        assert_that!((f64::from(compiled.at(versine)) - exact).abs() < 1e-5, degrees);
    }
}

#[test]
fn a_half_angle_is_half_a_full_angle() {
    let from_full = Cone::from_field(Soft, Angle::degrees(15.0));
    let from_half = Cone::from_field(Soft, HalfAngle::degrees(7.5));
    let from_radians = Cone::from_field(Soft, HalfAngle::radians(7.5_f32.to_radians()));
    assert_eq!(from_full, from_half);
    assert_eq!(from_full, from_radians);
    assert_eq!(HalfAngle::from(Angle::degrees(15.0)).to_degrees(), 7.5);
    assert_eq!(Angle::radians(core::f32::consts::PI).to_degrees(), 180.0);
}
