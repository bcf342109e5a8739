//! Bad input is refused at construction, by name, and the message says what would be accepted.

use luminaire::{Accepted, Angle, Cone, Edge, Error, Fx16, Fx32, Hard, Parameter, Rgb, Soft, Spot, Vec3};

const DOWN: Vec3<f32> = Vec3::new(0.0, -1.0, 0.0);
const ORIGIN: Vec3<f32> = Vec3::new(0.0, 0.0, 0.0);

fn cone() -> Cone<Soft> {
    Cone::from_field(Soft, Angle::degrees(15.0)).expect("a sound angle")
}

fn spot() -> Spot<Soft> {
    Spot::new(ORIGIN, DOWN, cone()).expect("a sound light")
}

fn assert_refused<T: core::fmt::Debug>(result: Result<T, Error>, parameter: Parameter, message: &str) {
    let error = result.expect_err(message);
    assert_eq!(error.parameter, parameter);
    assert_eq!(error.to_string(), message);
}

#[test]
fn field_angles_out_of_range() {
    for (degrees, shown) in
        [(0.0, "0"), (-15.0, "-15"), (400.0, "400"), (f32::NAN, "NaN"), (f32::INFINITY, "inf")]
    {
        let message = format!(
            "field angle {shown} is refused: give more than 0 and at most 143.13 degrees, the full angle"
        );
        assert_refused(Cone::from_field(Soft, Angle::degrees(degrees)), Parameter::FieldAngle, &message);
    }
}

/// The outer angle passes 180 degrees just beyond the angle that the message names.
#[test]
fn the_limit_that_a_message_names_is_the_limit() {
    type From = fn(Edge, Angle) -> Result<Cone, Error>;
    let constructors: [From; 3] = [Cone::from_field, Cone::from_beam, Cone::from_outer];
    for (constructor, edges) in constructors.into_iter().flat_map(|c| [(c, Edge::Soft), (c, Edge::Hard)]) {
        let refused = constructor(edges, Angle::degrees(400.0)).expect_err("no cone is that wide");
        let Accepted::AngleUpTo(limit) = refused.accepted else { panic!("{refused} names no limit") };
        let widest = constructor(edges, Angle::degrees(limit)).expect("the limit itself is accepted");
        assert!((widest.outer().to_degrees() - 180.0).abs() < 1e-3);
        assert!(constructor(edges, Angle::degrees(limit * 1.000_001)).is_err());
        let message = refused.to_string();
        let shown = message.split("at most ").nth(1).and_then(|rest| rest.split(' ').next());
        let shown: f32 = shown.and_then(|number| number.parse().ok()).expect("the message names a number");
        assert!(limit - shown < 0.01);
        assert!(constructor(edges, Angle::degrees(shown)).is_ok(), "{shown} is named but refused");
    }
}

#[test]
fn limits_are_the_models() {
    let limit = |result: Result<Cone<Edge>, Error>| match result.expect_err("too wide").accepted {
        Accepted::AngleUpTo(limit) => (limit * 100.0).floor() / 100.0,
        other => panic!("{other}"),
    };
    let wide = Angle::degrees(200.0);
    assert_eq!(limit(Cone::from_field(Edge::Soft, wide)), 143.13);
    assert_eq!(limit(Cone::from_field(Edge::Hard, wide)), 174.11);
    assert_eq!(limit(Cone::from_beam(Edge::Soft, wide)), 90.0);
    assert_eq!(limit(Cone::from_beam(Edge::Hard, wide)), 145.93);
    assert_eq!(limit(Cone::from_outer(Edge::Soft, wide)), 180.0);
}

#[test]
fn an_axis_without_a_direction() {
    let lengths = "give finite components and a length between 1e-18 and 1e18";
    let axes =
        [(ORIGIN, "0"), (Vec3::new(f32::NAN, 0.0, 1.0), "NaN"), (Vec3::new(f32::MAX, 0.0, 0.0), "inf")];
    for (axis, shown) in axes {
        let message = format!("axis {shown} is refused: {lengths}");
        assert_refused(Spot::new(ORIGIN, axis, cone()), Parameter::Axis, &message);
    }
}

#[test]
fn a_position_that_is_not_finite() {
    let position = Vec3::new(0.0, f32::INFINITY, 0.0);
    let error = Spot::new(position, DOWN, cone()).expect_err("not a place");
    assert_eq!((error.parameter, error.value), (Parameter::Position, f32::INFINITY));
}

#[test]
fn an_intensity_out_of_range() {
    for (intensity, shown) in [(-1.0, "-1"), (f32::NAN, "NaN"), (f32::INFINITY, "inf")] {
        let message = format!("intensity {shown} is refused: give a finite number from 0 to 1000000000");
        assert_refused(spot().with_intensity(intensity), Parameter::Intensity, &message);
    }
}

#[test]
fn a_color_out_of_range() {
    for value in [-0.1, 1.1, f32::NAN] {
        let error = spot().with_color(Rgb::new(0.5, value, 0.5)).expect_err("no such colour");
        assert_eq!(error.parameter, Parameter::Color);
    }
}

/// A format refuses a cone that it cannot hold to half a step of eight bits, and one of more bits takes it.
#[test]
fn a_cone_too_narrow_for_its_format() {
    // As narrow as even a step could not be.
    let needle = Cone::from_outer(Hard, Angle::degrees(0.1)).expect("a sound angle");
    let error = needle.compile::<Fx16>().expect_err("too narrow for 16 bits");
    assert_eq!(error.accepted, Accepted::AngleFrom(Cone::narrowest::<Fx16>(Hard).to_degrees()));
    let narrow = Cone::from_outer(Hard, Angle::degrees(1.0)).expect("a sound angle");
    let error = narrow.compile::<Fx16>().expect_err("too narrow for 16 bits");
    assert_eq!(error.parameter, Parameter::OuterAngle);
    let Accepted::AngleFrom(narrowest) = error.accepted else { panic!("{error} names no limit") };
    assert_eq!(narrowest, Cone::narrowest::<Fx16>(Hard).to_degrees());
    assert!(error.to_string().contains("or a number format of more bits"), "{error}");
    let shown = error.to_string();
    let shown = shown.split("at least ").nth(1).and_then(|rest| rest.split(' ').next());
    let shown: f32 = shown.and_then(|number| number.parse().ok()).expect("the message names a number");
    assert!(Cone::from_outer(Hard, Angle::degrees(shown)).expect("sound").compile::<Fx16>().is_ok());
    assert!(narrow.compile::<f32>().is_ok());
    assert!(narrow.compile::<Fx32>().is_ok());
    assert!(
        Cone::from_outer(Hard, Angle::degrees(narrowest * 1.001)).expect("sound").compile::<Fx16>().is_ok()
    );
}

/// A description with a refused change is still there: nothing is lost.
#[test]
fn a_refused_change_leaves_the_light() {
    let light = spot().with_intensity(3.0).expect("sound");
    assert!(light.with_intensity(-1.0).is_err());
    assert_eq!(light.intensity(), 3.0);
}
