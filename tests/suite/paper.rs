//! The figures of the paper, and the three angles of a cone as functions of one another.

use luminaire::{
    Angle, Cone, HalfAngle,
    falloff::{Hard, IntegerPower, Power, Soft},
};
use support::assert_that;
use support::oracle;

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
