//! The narrowest beam of each falloff in each format: where the error of a position reaches half of
//! one 8-bit step.

use fastrand::Rng;
use luminaire::{
    Cone, Fx16, Fx32, HalfAngle,
    falloff::{Falloff, Step},
};
use support::{falloffs::Shape, format::Format, oracle, sweep, with_every_shape};

const HALF_A_STEP: f64 = 1.0 / 510.0;

/// Half the narrowest outer angle that the format accepts of a shape, in degrees: all of its angles
/// in proportion.
fn narrowest<S: Format, P: Falloff>(shape: &Shape<P>) -> f32 {
    let (mut refused, mut held) = (1e-6_f32, 90.0_f32);
    for _ in 0..40 {
        let middle = (refused * held).sqrt();
        if shape.at(middle).compile::<S>().is_ok() { held = middle } else { refused = middle }
    }
    held
}

/// Where the intensity of a shape is steepest over the angle, as a fraction of its outer half
/// angle, and how steep.
fn steepest<P: Falloff>(shape: &Shape<P>) -> (f64, f64) {
    let cone = shape.exactly_at(0.5);
    let half = oracle::half_degrees(cone.limit);
    let at = |x: f64| cone.falloff(oracle::versine(x * half));
    let slope = |x: f64| (x, (at(x - 1e-6) - at(x + 1e-6)) / 2e-6);
    (1..99_999)
        .map(|i| slope(f64::from(i) / 100_000.0))
        .fold((0.0, 0.0), |a, b| if b.1 > a.1 { b } else { a })
}

/// The largest error of the intensity where a shape is steepest, at the narrowest cone the format
/// accepts.
fn error_at_the_narrowest<S: Format, P: Falloff>(shape: &Shape<P>) -> f64 {
    let half_degrees = narrowest::<S, P>(shape) * 1.000_01;
    let (cone, (steepest, _)) = (shape.at(half_degrees), steepest(shape));
    let radians = f64::from(half_degrees).to_radians();
    let mut rng = Rng::with_seed(1927);
    let mut worst = 0.0_f64;
    for _ in 0..200 * sweep::effort() {
        let spot = sweep::spot(&mut rng, cone);
        let compiled = spot.compile::<S>().expect("the narrowest cone is accepted");
        let exact = sweep::stored::<S, _, _>(&spot, shape.exactly_at(half_degrees));
        for _ in 0..2_000 {
            let off_axis = radians * (steepest + 0.1 * (rng.f64() - 0.5)).min(1.0);
            let way = sweep::direction_off(&mut rng, exact.axis, off_axis);
            let point = sweep::on_grid(exact.position + 50.0 * rng.f64().max(0.1) * way);
            let stored = sweep::single(point).map(S::length);
            let error = (compiled.falloff_at(stored).exact() - exact.falloff(point)).abs();
            worst = worst.max(oracle::counted(error));
        }
    }
    worst
}

/// The error at the narrowest cone keeps its bound, and the bound is not loose: the error is at
/// least 0.25 of it. Shapes that jump have no such error. A table is tested against the upper bound
/// only, because its steepness is itself a bound. `Fx16` evaluates its narrowest cones finely, so
/// that only the last rounding is left.
fn assert_narrowest<S: Format, P: Falloff>(shape: &Shape<P>) {
    if shape.exactly_at(1.0).jumps_near(shape.exactly_at(1.0).limit, 1.0) {
        return;
    }
    let error = error_at_the_narrowest::<S, P>(shape);
    let half = narrowest::<S, P>(shape);
    println!("{} {}: narrowest half angle {half:.5} degrees, error {error:.2e}", S::NAME, shape.name);
    let least = match (S::NAME, shape.name) {
        ("fx16", _) => 0.01,
        (_, "table") => 0.2,
        _ => 0.25,
    };
    assert!((least * HALF_A_STEP..=HALF_A_STEP).contains(&error), "{} {}: {error:.2e}", S::NAME, shape.name);
}

#[test]
fn f32_holds_what_it_states() {
    with_every_shape!(assert_narrowest::<f32>);
}

#[test]
fn fx32_holds_what_it_states() {
    with_every_shape!(assert_narrowest::<Fx32>);
}

#[test]
fn fx16_holds_what_it_states() {
    with_every_shape!(assert_narrowest::<Fx16>);
}

/// A jump is at the specified angle, within 1/510 of its half angle, in the narrowest cone that a
/// format holds.
#[test]
fn a_step_is_in_its_place() {
    fn assert_place<S: Format>() {
        let half = HalfAngle::from(Cone::narrowest::<S>(Step)).to_degrees() * 1.000_01;
        let cone = Cone::from_outer(Step, HalfAngle::degrees(half)).expect("a sound cone");
        let mut rng = Rng::with_seed(510);
        for _ in 0..200 {
            let spot = sweep::spot(&mut rng, cone);
            let compiled = spot.compile::<S>().expect("the narrowest cone is accepted");
            let position = S::exact_point(spot.position().map(S::length));
            let axis = S::exact_direction(spot.axis_in::<S>()).normalize();
            for _ in 0..500 {
                let inside = rng.bool();
                let fraction = if inside { 1.0 - 1.1 / 510.0 } else { 1.0 + 1.1 / 510.0 };
                let way = sweep::direction_off(&mut rng, axis, fraction * f64::from(half).to_radians());
                let point = sweep::on_grid(position + 1_000.0 * way);
                let intensity = compiled.falloff_at(sweep::single(point).map(S::length)).exact();
                assert_eq!(intensity, f64::from(u8::from(inside)), "{} {half}", S::NAME);
            }
        }
    }
    assert_place::<Fx16>();
}
