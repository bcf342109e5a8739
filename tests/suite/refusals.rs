//! Constructors refuse bad input. The message names the parameter, the value, what would be
//! accepted and, where there is one, the remedy.

use fastrand::Rng;
use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, Error, Fx16, Fx32, Material, PointLight, Rgb, SpotLight,
    Vec3,
    attenuation::{CutAt, FilamentRange, GltfRange, InverseSquare, Polynomial, SmoothRange},
    display::Exposure,
    error::{Expected, Parameter},
    falloff::{AnyFalloff, Hard, InvertedPower, Linear, RealPower, Soft, SoftOrHard},
    haze::Haze,
    specular::{BlinnPhong, DifferenceForm, Phong},
};
use support::assert_in;

const DOWN: Vec3<f32> = Vec3::new(0.0, -1.0, 0.0);
const ORIGIN: Vec3<f32> = Vec3::new(0.0, 0.0, 0.0);
const GREY: Rgb<f32> = Rgb::new(0.5, 0.5, 0.5);

fn cone() -> Cone<Soft> {
    Cone::from_field(Soft, Angle::degrees(15.0)).expect("a sound angle")
}

fn spot() -> SpotLight<Soft> {
    SpotLight::new(ORIGIN, DOWN, cone()).expect("a sound light")
}

#[track_caller]
pub(crate) fn assert_refused<T: core::fmt::Debug>(result: Result<T, Error>, message: &str) {
    assert_eq!(result.expect_err(message).to_string(), message);
}

/// Values out of range, infinite and NaN, of every parameter that is a number.
#[test]
fn numbers_out_of_range() {
    for (degrees, shown) in
        [(0.0, "0"), (-15.0, "-15"), (400.0, "400"), (f32::NAN, "NaN"), (f32::INFINITY, "inf")]
    {
        let range = "expected more than 0 and at most 143.13 degrees (full angle)";
        let cone = Cone::from_field(Soft, Angle::degrees(degrees));
        assert_refused(cone, &format!("field angle = {shown}: {range}"));
    }
    // Shown with an exponent: in full, the first of the last two has 39 digits and the second 38
    // zeros.
    for (intensity, shown) in
        [(-1.0, "-1"), (f32::NAN, "NaN"), (f32::INFINITY, "inf"), (3.4e38, "3.4e38"), (-1e-38, "-1e-38")]
    {
        let message = format!("intensity = {shown}: expected a finite number from 0 to 1000000000");
        assert_refused(spot().with_intensity(intensity), &message);
    }
    // A light without a range uses an attenuation without one, or `None`.
    for (range, shown) in [(0.0, "0"), (-2.0, "-2"), (f32::NAN, "NaN"), (f32::INFINITY, "inf")] {
        let remedy = "or an attenuation without a range";
        let message = format!("range = {shown}: expected a distance from 0.001 to 1000000000, {remedy}");
        assert_refused(SmoothRange::new(range), &message);
        assert_refused(GltfRange::new(InverseSquare, Some(range)), &message);
        assert_refused(FilamentRange::new(InverseSquare, Some(range)), &message);
        assert_refused(CutAt::new(InverseSquare, Some(range)), &message);
    }
    let message = "attenuation coefficient = -1: expected a finite number from 0 to 1000000000";
    for [constant, linear, quadratic] in [[-1.0, 0.0, 0.0], [1.0, -1.0, 0.0], [1.0, 0.0, -1.0]] {
        assert_refused(Polynomial::new(constant, linear, quadratic), message);
    }
    assert!(Polynomial::new(1.0, f32::NAN, 0.0).is_err());
    let matte = Material::new(GREY).expect("sound");
    for (shininess, shown) in [(0, "0"), (1025, "1025")] {
        let message = format!("shininess = {shown}: expected a whole number from 1 to 1024");
        assert_refused(matte.with_highlight(BlinnPhong, GREY, shininess), &message);
    }
    let message = "shininess = 7: expected a whole number from 8 to 1024";
    assert_refused(matte.with_highlight(DifferenceForm::<_, 3>(Phong), GREY, 7), message);
    assert_refused(Exposure::stops(25), "exposure = 25: expected a finite number from -24 to 24");
    assert!(Exposure::factor(-1.0).is_err());
    for (density, shown) in [(-0.5, "-0.5"), (f32::NAN, "NaN"), (f32::INFINITY, "inf")] {
        let message = format!("density = {shown}: expected a finite number from 0 to 1000000000");
        assert_refused(Haze::new(density), &message);
    }
    let clear = Haze::new(0.0).expect("clear air");
    for (radius, shown) in [(0.0, "0"), (f32::NAN, "NaN"), (2e9, "2000000000")] {
        let message = format!("source radius = {shown}: expected a finite number from 0.001 to 1000000000");
        assert_refused(clear.with_source_radius(radius), &message);
    }
}

/// Vectors without a direction, and places that are none.
#[test]
fn vectors_that_are_none() {
    let lengths = "expected finite components and a length between 1e-18 and 1e18";
    let ahead = |x| Vec3::new(x, 0.0, 0.0);
    for (axis, shown) in [
        (ORIGIN, "0"),
        (Vec3::new(f32::NAN, 0.0, 1.0), "NaN"),
        (ahead(f32::MAX), "3.4028235e38"),
        (ahead(f32::INFINITY), "inf"),
        (ahead(1e-45), "1e-45"),
    ] {
        assert_refused(SpotLight::new(ORIGIN, axis, cone()), &format!("axis = {shown}: {lengths}"));
        assert_refused(spot().with_axis(axis), &format!("axis = {shown}: {lengths}"));
    }
    for (length, is_sound) in
        [(0.999_5e-18, false), (1.000_5e-18, true), (0.999_5e18, true), (1.000_5e18, false)]
    {
        let axis = Vec3::new(0.0, length, 0.0);
        assert_eq!(SpotLight::new(ORIGIN, axis, cone()).is_ok(), is_sound, "{length:e}");
    }
    assert_refused(DirectionalLight::new(ORIGIN), &format!("direction = 0: {lengths}"));
    assert_refused(SpotLight::between(DOWN, DOWN, cone()), &format!("end point = 0: {lengths}"));
    let parameter = |end| SpotLight::between(ORIGIN, end, cone()).expect_err("no end").parameter;
    assert_eq!(parameter(Vec3::new(f32::NAN, 0.0, 0.0)), Parameter::EndPoint);
    assert_eq!(parameter(Vec3::new(1e-6, 0.0, 0.0)), Parameter::Range, "too short");
    for no_place in [f32::INFINITY, f32::NAN] {
        let place = Vec3::new(0.0, no_place, 0.0);
        let refused = [SpotLight::new(place, DOWN, cone()).map(drop), PointLight::new(place).map(drop)];
        assert!(refused.iter().all(|refused| refused.is_err_and(|e| e.parameter == Parameter::Position)));
    }
}

/// Just beyond the angle that the message names, the outer angle exceeds 180 degrees.
#[test]
fn the_limit_that_a_message_names_is_the_limit() {
    type From = fn(SoftOrHard, Angle) -> Result<Cone<SoftOrHard>, Error>;
    let constructors: [From; 3] = [Cone::from_field, Cone::from_beam, Cone::from_outer];
    for (constructor, edges) in
        constructors.into_iter().flat_map(|c| [(c, SoftOrHard::Soft), (c, SoftOrHard::Hard)])
    {
        let refused = constructor(edges, Angle::degrees(400.0)).expect_err("no cone is that wide");
        let Expected::AngleUpTo(limit) = refused.accepted else { panic!("{refused} names no limit") };
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

/// A format refuses a cone that it cannot evaluate within half a step of eight bits. A format of
/// more bits accepts the cone.
#[test]
fn a_cone_too_narrow_for_its_format() {
    // Too narrow even for the falloff `Step`.
    let needle = Cone::from_outer(Hard, Angle::degrees(0.1)).expect("a sound angle");
    let error = needle.compile::<Fx16>().expect_err("too narrow for 16 bits");
    assert_eq!(error.accepted, Expected::AngleFrom(Cone::narrowest::<Fx16>(Hard).to_degrees()));
    let narrow = Cone::from_outer(Hard, Angle::degrees(1.0)).expect("a sound angle");
    let error = narrow.compile::<Fx16>().expect_err("too narrow for 16 bits");
    assert_eq!(error.parameter, Parameter::OuterAngle);
    let Expected::AngleFrom(narrowest) = error.accepted else { panic!("{error} names no limit") };
    assert_eq!(narrowest, Cone::narrowest::<Fx16>(Hard).to_degrees());
    assert!(error.to_string().contains("or a number format of more bits"), "{error}");
    let shown = error.to_string();
    let shown = shown.split("at least ").nth(1).and_then(|rest| rest.split(' ').next());
    let shown: f32 = shown.and_then(|number| number.parse().ok()).expect("the message names a number");
    assert!(Cone::from_outer(Hard, Angle::degrees(shown)).expect("sound").compile::<Fx16>().is_ok());
    assert!(narrow.compile::<f32>().is_ok());
    assert!(narrow.compile::<Fx32>().is_ok());
    let steep = Cone::from_outer(InvertedPower::<100>, Angle::degrees(180.0)).expect("a sound angle");
    let error = steep.compile::<Fx16>().expect_err("too steep for 16 bits").to_string();
    assert!(error.contains("no angle up to 180 degrees is wide enough"), "{error}");
    assert!(
        Cone::from_outer(Hard, Angle::degrees(narrowest * 1.001)).expect("sound").compile::<Fx16>().is_ok()
    );
}

/// Every kind of light and every material has the same limits of colour and intensity.
#[test]
fn what_lights_and_materials_share() {
    let wrong = Rgb::new(0.5, 0.5, 1.5);
    let (sun, bulb) = (DirectionalLight::new(DOWN).expect("sound"), PointLight::new(ORIGIN).expect("sound"));
    let matte = Material::new(GREY).expect("sound");
    let colors = [
        sun.with_color(wrong).err(),
        bulb.with_color(wrong).err(),
        spot().with_specular_color(wrong).err(),
        AmbientLight::new(wrong).err(),
        Material::new(wrong).err(),
        matte.with_ambient(wrong).err(),
        matte.with_emissive(wrong).err(),
        matte.with_highlight(Phong, wrong, 8).err(),
    ];
    let message = "color = 1.5: expected a finite number from 0 to 1 (blue)";
    assert!(colors.iter().all(|error| error.is_some_and(|error| error.to_string() == message)), "{colors:?}");
    let intensities = [
        sun.with_intensity(-1.0).err(),
        bulb.with_intensity(-1.0).err(),
        AmbientLight::new(GREY).and_then(|ambient| ambient.with_intensity(-1.0)).err(),
    ];
    assert!(intensities.iter().all(|error| error.is_some_and(|e| e.parameter == Parameter::Intensity)));
}

/// An angle that was derived from another is shown rounded to four decimals.
#[test]
fn derived_values_are_shown_to_four_decimals() {
    let cone = Cone::from_field(Hard, Angle::degrees(1.0)).expect("a sound angle");
    let message = cone.compile::<Fx16>().expect_err("too narrow for 16 bits").to_string();
    assert!(message.starts_with("outer angle = 1.0267: expected"), "{message}");
}

#[test]
fn numbers_are_shown_in_full_between_their_limits() {
    let shown = |intensity: f32| {
        let refused = spot().with_color(Rgb::new(intensity, 0.0, 0.0)).expect_err("out of range");
        refused.to_string().split(':').next().map(str::to_owned).expect("a parameter and its value")
    };
    assert_eq!(shown(1.000_5e12), "color = 1.0005e12");
    assert_eq!(shown(9.995e11), "color = 999500000000");
    assert_eq!(shown(12_345.678), "color = 12345.678");
    let exponent = RealPower::new(1_024.123_4).expect_err("over the limit");
    assert_eq!(exponent.to_string(), "exponent = 1024.1234: expected more than 0 and at most 1024");
    let refused =
        |value| Error { parameter: Parameter::Range, value, accepted: Expected::Exactly(1.0) }.to_string();
    assert_eq!(refused(0.001_000_4), "range = 0.001: expected 1");
    assert_eq!(refused(0.000_999_94), "range = 0.00099994: expected 1");
    assert_eq!(refused(1e-6), "range = 0.000001: expected 1");
    assert_eq!(refused(1e-6_f32.next_down()), "range = 9.999999e-7: expected 1");
    let side =
        Error { value: 8_589_934_592.0, parameter: Parameter::Side, accepted: Expected::WholeBetween(1, 9) };
    assert_eq!(side.to_string(), "side = 8589934592: expected a whole number from 1 to 9");
    // Rounded to four decimals, the value would be within the limits.
    assert_eq!(refused(1.000_01), "range = 1.00001: expected 1");
    // Limits are rounded inwards, and a limit below 1 keeps its digits.
    assert_eq!(
        Expected::AngleUpTo(0.000_123_4).to_string(),
        "more than 0 and at most 0.000123 degrees (full angle)"
    );
    assert_eq!(Expected::AngleBetween(1e-5, 2e-5).to_string(), "0.00001 to 0.00002 degrees (full angle)");
    assert_eq!(Expected::AngleBetween(180.0, 180.0).to_string(), "180 degrees (full angle)");
    assert_eq!(Expected::AngleBetween(1.000_01, 2.000_09).to_string(), "1.0001 to 2 degrees (full angle)");
    let narrowest = |degrees| Expected::AngleFrom(degrees).to_string();
    assert!(narrowest(180.0).starts_with("at least 180"));
    assert!(narrowest(180.01).starts_with("a number format of more bits"));
}

/// The steepest edge of a format: the inner angles up to it are accepted, from 0 on, and its slope
/// is the one at which the errors of the direction and of the versine reach half a code.
#[test]
fn an_inner_angle_too_near_to_the_outer_one() {
    let cone = Cone::from_outer(Linear, Angle::degrees(10.0)).expect("a sound angle");
    let steep = cone.with_inner(Angle::degrees(9.999_9)).expect("sound but for its format");
    let error = steep.compile::<f32>().expect_err("too steep");
    assert_eq!(error.parameter, Parameter::InnerAngle);
    let Expected::AngleBetween(least, most) = error.accepted else { panic!("{error} names no limits") };
    assert_eq!(least, 0.0);
    let versine = |degrees: f32| f64::from(Angle::degrees(degrees).versine());
    let slope = 2.0 / (1.0 - versine(most) / versine(10.0));
    let outer = 10_f64.to_radians();
    let exact = outer / 510.0 / (2.0 * 1.12e-7 + 0.55e-6 * outer);
    assert_in(&"of the exact slope", slope / exact, 0.95..=1.05);
}

/// A position outside the range of a format is refused when the light is compiled for that format,
/// not before.
#[test]
fn a_position_beyond_the_reach_of_its_format() {
    let far = SpotLight::new(Vec3::new(0.0, 40_000.0, 0.0), DOWN, cone()).expect("a sound light");
    assert!(far.compile::<f32>().is_ok());
    let message = |most| format!("position = 40000: expected a finite number from -{most} to {most} (y)");
    assert_refused(far.compile::<Fx16>(), &message(16_383));
    assert_refused(far.compile::<Fx32>(), &message(32_639));
    let light = luminaire::PointLight::new(Vec3::new(0.0, 0.0, -40_000.0)).expect("a sound light");
    assert!(light.compile::<Fx16>().is_err());
}

/// An angle above zero whose versine rounds to zero is refused: the cone would have no light, or
/// the ratio of field and beam would be undefined.
#[test]
fn angles_too_small_for_a_versine() {
    let tiny = Angle::degrees(1e-30);
    for refused in [
        Cone::from_outer(Soft, tiny).map(drop),
        cone().with_cutoff(tiny).map(drop),
        Cone::from_beam_and_field(tiny, Angle::degrees(2e-30)).map(drop),
        Cone::edge_slopes(tiny, Angle::degrees(2e-30)).map(drop),
    ] {
        let error = refused.expect_err("no such cone");
        assert_eq!(error.value, 1e-30);
        let message = error.to_string();
        assert!(message.contains("angle = 1e-30: expected 2e-17 to "), "{message}");
    }
}

/// The limits in a message: the numbers between which a value is accepted.
fn limits(message: &str) -> Option<[f32; 2]> {
    let numbers: Vec<f32> = message
        .split("expected ")
        .nth(1)?
        .split([' ', ':', ','])
        .filter_map(|word| word.parse().ok())
        .collect();
    match numbers[..] {
        [most] if message.contains("at least") => Some([most, f32::INFINITY]),
        [most] => Some([most, most]),
        [0.0, most] if message.contains("more than") => Some([f32::MIN_POSITIVE, most]),
        [least, most] => Some([least, most]),
        _ => None,
    }
}

/// Asserts that a refused value is outside the limits that its message names, and that the nearest
/// limit is accepted. Where no angle is accepted, the limits are 0.
fn assert_names_its_limits(result: Result<(), Error>, accepts: impl Fn(f32) -> Result<(), Error>) -> bool {
    let Err(error) = result else { return false };
    let message = error.to_string();
    let Some([least, most]) = limits(&message) else { return false };
    let value: f32 =
        message.split([':', '=']).nth(1).and_then(|value| value.trim().parse().ok()).expect("a value");
    if most == 0.0 {
        return false;
    }
    assert!(least <= most, "{message}: no number is accepted");
    assert!(!(least..=most).contains(&value), "{message}: the value is accepted by its message");
    let nearest = if value < least { least } else { most };
    let nearest = if message.contains("more than") && value < least { most } else { nearest };
    assert!(accepts(nearest).is_ok(), "{message}: {nearest} is refused: {:?}", accepts(nearest));
    true
}

/// A number from very small to very large, often next to a given one.
fn hostile(rng: &mut Rng, near: f32) -> f32 {
    match rng.u8(..6) {
        0 => f32::from_bits(rng.u32(..)),
        1 => near * (1.0 + 1e-6 * (rng.f32() - 0.5)),
        2 => near.next_up(),
        3 => 180.0 * (rng.f32() - 0.1),
        _ => near * 2.0_f32.powf(8.0 * (rng.f32() - 0.5)),
    }
}

/// No message contradicts itself, with and without a hotspot and a cutoff. The limits of two angles
/// and of a format are searched, so the angle just at them may be refused.
#[test]
fn the_limits_of_a_message_do_not_hold_its_value() {
    type From = fn(AnyFalloff, Angle) -> Result<Cone<AnyFalloff>, Error>;
    const CONSTRUCTORS: [From; 3] = [Cone::from_outer, Cone::from_field, Cone::from_beam];
    let (mut rng, mut refused) = (Rng::with_seed(0x11_e175), [0; 5]);
    let rng = &mut rng;
    for _ in 0..4_000 {
        let Ok(falloff) = AnyFalloff::anywhere(rng.usize(..), || rng.f32()) else { continue };
        let from = CONSTRUCTORS[rng.usize(..3)];
        let make = |degrees| from(falloff, Angle::degrees(degrees)).map(drop);
        refused[0] += u32::from(assert_names_its_limits(make(hostile(rng, 150.0)), make));
        let outer = 2.0_f32.powf(7.49 - 20.0 * rng.f32().powi(3));
        let Ok(cone) = Cone::from_outer(falloff, Angle::degrees(outer)) else { continue };
        let inner = |degrees| cone.with_inner(Angle::degrees(degrees)).map(drop);
        refused[1] += u32::from(assert_names_its_limits(inner(hostile(rng, outer)), inner));
        let cutoff = |degrees| cone.with_cutoff(Angle::degrees(degrees)).map(drop);
        refused[2] += u32::from(assert_names_its_limits(cutoff(hostile(rng, outer)), cutoff));
        let two = |field| Cone::from_beam_and_field(Angle::degrees(outer), Angle::degrees(field)).map(drop);
        refused[3] += u32::from(assert_names_its_limits(two(hostile(rng, 2.0 * outer)), |_| Ok(())));
        let (share, is_cut) = (1.0 - 2.0_f32.powf(-20.0 * rng.f32()), rng.bool());
        let limit = outer * rng.f32();
        let held = |cone: Cone<AnyFalloff>, kind: u8| {
            let spot = SpotLight::new(ORIGIN, DOWN, cone)?;
            match kind {
                0 => spot.compile::<Fx16>().map(drop),
                1 => spot.compile::<Fx32>().map(drop),
                _ => spot.compile_quick::<Fx16>().map(drop),
            }
        };
        for kind in 0..3 {
            let with_inner = |degrees| {
                let cone = cone.with_inner(Angle::degrees(degrees))?;
                held(if is_cut { cone.with_cutoff(Angle::degrees(limit))? } else { cone }, kind)
            };
            let result = with_inner(outer * share);
            if result.is_err_and(|error| error.parameter == Parameter::InnerAngle) {
                refused[4] += u32::from(assert_names_its_limits(result, |_| Ok(())));
            }
        }
    }
    assert!(refused.iter().all(|&count| count > 300), "only {refused:?} are refused");
}
