//! Constructors accept a description, or return an error that names the parameter and what they
//! would accept.

use super::scene::{self};
use super::words::Words;
use luminaire::{
    Angle, Cone, Error, Scalar,
    error::{Expected, Parameter},
    falloff::Falloff,
};

/// A cone made from any numbers has its angles in order: inner, beam, field, outer. A format
/// supports the cone, or its error names an angle that the format supports. It supports the narrowest
/// cone of a falloff, and none below.
pub fn descriptions_are_taken_or_refused<S: Scalar>(words: &[u32]) {
    let _: Option<()> = description::<S>(&mut Words::new(words));
}

fn description<S: Scalar>(words: &mut Words<'_>) -> Option<()> {
    let falloff = scene::falloff(words)?;
    let cone = scene::cone::<S, _>(words, falloff)?;
    let (inner, beam, field, outer) = (cone.inner(), cone.beam(), cone.field(), cone.outer());
    assert!(
        inner <= beam && beam <= field && field <= outer,
        "{cone:?}, expected inner <= beam and beam <= field and field <= outer"
    );
    assert!(
        outer > Angle::degrees(0.0) && outer <= Angle::degrees(180.0),
        "{cone:?}, expected outer > Angle::degrees(0.0) and outer <= Angle::degrees(180.0)"
    );
    assert!(
        cone.lumens(1.0) >= 0.0 && cone.lumens(1.0).is_finite(),
        "{cone:?}, expected cone.lumens(1.0) >= 0.0 and cone.lumens(1.0).is_finite()"
    );
    assert_held::<S, _>(cone);
    let narrowest = scene::narrowest::<S, _>(falloff).to_degrees();
    if narrowest <= 180.0 {
        let [held, refused] = [1.0, 0.999_9].map(|part| {
            let cone = Cone::from_outer(falloff, Angle::degrees(narrowest * part)).ok();
            cone.is_some_and(|cone| cone.compile::<S>().is_ok())
        });
        assert!(held && !refused, "{falloff:?} {narrowest}: held {held}, just below refused {}", !refused);
    }
    Some(())
}

/// If a format refuses a cone, it accepts the cone without a hotspot at the angle that the error
/// names. If that angle is more than 180 degrees, it accepts none.
fn assert_held<S: Scalar, P: Falloff>(cone: Cone<P>) {
    let Err(error) = cone.compile::<S>() else { return };
    assert!(!error.to_string().is_empty());
    if let Error { parameter: Parameter::OuterAngle, accepted: Expected::AngleFrom(least), .. } = error {
        let plain = Cone::from_outer(cone.falloff(), Angle::degrees((least * 1.000_01).min(180.0)));
        if cone.inner() < cone.outer() {
            let is_held = plain.is_ok_and(|plain| plain.compile::<S>().is_ok());
            assert_eq!(is_held, least <= 180.0, "{}: {error}", S::NAME);
        }
    }
}

/// A cone designed from beam and field angle has these angles, or the error names a range of field
/// angles, of which both ends are accepted, or refuses the beam angle.
pub fn two_angles_come_back(words: &[u32]) {
    let words = &mut Words::new(words);
    let beam = words.number(-8.0, 7.5).exp2();
    let field = beam * words.number(0.9, 3.0);
    match Cone::from_beam_and_field(Angle::degrees(beam), Angle::degrees(field)) {
        Ok(cone) => {
            let near = |found: Angle, given: f32| (found.to_degrees() / given - 1.0).abs() < 1e-4;
            assert!(
                near(cone.beam(), beam) && near(cone.field(), field),
                "{beam} {field}: {cone:?}, expected near(cone.beam(), beam) and near(cone.field(), field)"
            );
        }
        Err(error) => {
            assert!(!error.to_string().is_empty());
            if let (Parameter::FieldAngle, Expected::AngleBetween(least, most)) =
                (error.parameter, error.accepted)
            {
                // The conversion between versine and degrees rounds a few times.
                for nearest in [least * 1.000_001, most * 0.999_999] {
                    let cone = Cone::from_beam_and_field(Angle::degrees(beam), Angle::degrees(nearest));
                    assert!(cone.is_ok(), "{beam} {field}: {error}, but {nearest} is refused");
                }
            }
        }
    }
}
