//! The figures of the paper, and the three angles of a cone as functions of one another.

use luminaire::{
    Angle, Cone, HalfAngle,
    falloff::{Falloff, Hard, IntegerPower, Power, Soft, SoftOrHard},
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

/// Each angle of a cone determines the other two, and from these it is restored to a few units in
/// the last place.
fn assert_angles_follow<P: Falloff>(falloff: P) {
    for tenths in 1..1790_u16 {
        let outer = Angle::degrees(f32::from(tenths) / 10.0);
        let cone = Cone::from_outer(falloff, outer).expect("a sound angle");
        let within = 2e-6 * outer.to_degrees();
        assert_degrees("outer", cone.outer(), outer.to_degrees(), within);
        let from_field = Cone::from_field(falloff, cone.field()).expect("a sound angle");
        let from_beam = Cone::from_beam(falloff, cone.beam()).expect("a sound angle");
        for same in [from_field, from_beam] {
            assert_degrees("outer", same.outer(), outer.to_degrees(), within);
            assert_degrees("field", same.field(), cone.field().to_degrees(), within);
            assert_degrees("beam", same.beam(), cone.beam().to_degrees(), within);
        }
    }
}

#[test]
fn soft_angles_follow_one_another() {
    assert_angles_follow(Soft);
}

#[test]
fn hard_angles_follow_one_another() {
    assert_angles_follow(Hard);
}

/// At the beam angle that the getter returns, the reference has half the intensity, and at the
/// field angle a tenth.
#[test]
fn beam_and_field_are_where_the_intensity_says() {
    for (edge, oracle) in
        [(SoftOrHard::Soft, oracle::soft as oracle::Falloff), (SoftOrHard::Hard, oracle::hard)]
    {
        for degrees in [0.02, 0.2, 1.0, 7.0, 15.0, 30.0, 60.0, 120.0, 178.0_f32] {
            let cone = Cone::from_outer(edge, Angle::degrees(degrees)).expect("a sound angle");
            let outer = oracle::versine(f64::from(degrees) / 2.0);
            let intensity = |angle: Angle| {
                let half = HalfAngle::from(angle).to_degrees();
                oracle::falloff(oracle, oracle::versine(half.into()), outer)
            };
            assert_that!((intensity(cone.beam()) - 0.5).abs() < 1e-6, edge, degrees);
            assert_that!((intensity(cone.field()) - 0.1).abs() < 1e-6, edge, degrees);
        }
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

/// The versine of an angle against f64, over all angles a cone can have.
#[test]
fn versines_keep_their_relative_error() {
    let worst = (1..=180_000)
        .map(|millidegrees| {
            let degrees = millidegrees as f32 / 1000.0;
            let exact = oracle::versine(f64::from(degrees) / 2.0);
            (f64::from(Angle::degrees(degrees).versine()) / exact - 1.0).abs()
        })
        .fold(0.0, f64::max);
    assert!((2e-7..=4e-7).contains(&worst), "largest relative error {worst:.2e}");
}
