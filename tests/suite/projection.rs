//! The square that a spotlight projects: its orientation, the position of a point on it against
//! f64, and a defined result for every point.

use fastrand::Rng;
use luminaire::codegen::{FloatFrame, Frame16, Frame32};
use luminaire::{
    Angle, Cone, Error, Fx16, Fx32, SpotLight, Vec3,
    error::{Expected, Parameter},
    falloff::{Power, Step},
    projector::{CompiledProjection, ProjectedPoint, Projection},
};
use support::{
    arbitrary::{bits, vector},
    assert_that,
    bounds::{self, REFUSE},
    format::Format,
    in_every_format,
    squares::Square,
    sweep,
};

const SIDE: f64 = 65_536.0;

/// In place of a half angle: the narrowest cone of a format.
const NARROWEST: f32 = 0.0;

fn spot(position: [f32; 3], axis: [f32; 3], degrees: f32) -> SpotLight<Step> {
    let [position, axis] = [position, axis].map(|[x, y, z]| Vec3::new(x, y, z));
    let cone = Cone::from_outer(Step, Angle::degrees(degrees)).expect("a sound cone");
    SpotLight::new(position, axis, cone).expect("a sound light")
}

fn square(axis: [f32; 3]) -> Projection {
    Projection::of(&spot([0.0; 3], axis, 40.0)).expect("not too wide")
}

fn rolled(spot: &SpotLight<Step>, degrees: f32) -> Result<Projection, Error> {
    Projection::of(spot)?.turned(Angle::degrees(degrees))
}

/// The largest errors of position and depth with one cone, if the format holds it, over points on
/// the whole square of randomly turned lights.
fn errors<S: Format>(half_degrees: f32) -> [f64; 2] {
    let mut rng = Rng::with_seed(45);
    let narrowest = Cone::narrowest::<S>(Step).to_degrees() / 2.0;
    let half_degrees = if half_degrees == NARROWEST { 1.000_1 * narrowest } else { half_degrees };
    if half_degrees < narrowest {
        return [REFUSE; 2];
    }
    let cone = Cone::from_outer(Step, sweep::half(half_degrees)).expect("a sound cone");
    let (mut worst_place, mut worst_depth) = (0.0_f64, 0.0_f64);
    for _ in 0..100 * sweep::effort() {
        let (spot, roll) = (sweep::spot(&mut rng, cone), 720.0 * rng.f32() - 360.0);
        let compiled = rolled(&spot, roll).and_then(|square| square.compile::<S>()).expect("held");
        let square = Square::stored::<S, _, _>(&spot, half_degrees.into(), roll.into());
        for _ in 0..2_000 {
            let place = [rng.f64(), rng.f64(), sweep::distance(&mut rng)];
            let point = sweep::single(sweep::on_grid(square.point(place))).map(S::length);
            let [column, row, depth] = square.project(S::exact_point(point));
            // The quantum of a length may be larger than the side of the narrowest square.
            if ![column, row].iter().all(|place| (-0.9..1.9).contains(place)) {
                continue;
            }
            let found = compiled.project(point);
            for (found, exact) in [(found.column, column), (found.row, row)] {
                worst_place = worst_place.max(((f64::from(found) + 0.5) / SIDE - exact).abs());
            }
            worst_depth = worst_depth.max((S::exact_length(found.depth) / depth - 1.0).abs());
        }
    }
    [worst_place, worst_depth]
}

#[test]
fn places_keep_their_rows() {
    const HALF_ANGLES: [f32; 11] = [0.01, 0.1, 0.5, 1.0, 2.0, 3.5, 7.5, 15.0, 30.0, 60.0, 80.0];
    let named = HALF_ANGLES.map(|half| (format!("{half} degrees"), half));
    let mut broken = Vec::new();
    for (name, half) in [("narrowest".to_owned(), NARROWEST)].into_iter().chain(named) {
        let measured = [errors::<f32>(half), errors::<Fx32>(half), errors::<Fx16>(half)];
        println!("{name}: {:?}", measured.map(|errors| bounds::shown(&errors)));
        for (format, measured) in ["f32", "fx32", "fx16"].into_iter().zip(measured) {
            broken.extend(bounds::broken("square", &name, format, &measured));
        }
    }
    bounds::assert_kept(&broken);
}

/// The directions right and up on the squares of lights that point along the axes of the world, and
/// of some that do not.
#[test]
fn a_square_stands_upright() {
    let (x, y, z) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0));
    let minus = |v: Vec3<f32>| v.map(|c| -c);
    for (axis, right, up) in [
        ([0.0, 0.0, -1.0], x, y),
        ([0.0, 0.0, 1.0], minus(x), y),
        ([1.0, 0.0, 0.0], z, y),
        ([-1.0, 0.0, 0.0], minus(z), y),
        ([0.0, -1.0, 0.0], x, minus(z)),
        ([0.0, 1.0, 0.0], x, z),
        ([0.0, -0.8, -0.6], x, Vec3::new(0.0, 0.6, -0.8)),
        ([0.0, 0.8, -0.6], x, Vec3::new(0.0, 0.6, 0.8)),
    ] {
        let square = square(axis);
        assert_eq!((square.right(), square.up()), (right, up), "{axis:?}");
        let Vec3 { x, y, z } = square.axis();
        assert_eq!([x, y, z], axis);
    }
}

/// The axis of a light that is computed to point straight down has rounding errors, which must not
/// turn its square.
#[test]
fn roundings_do_not_turn_a_square_that_points_straight_down() {
    let mut rng = Rng::with_seed(180);
    for _ in 0..10_000 {
        let [x, z] = [0; 2].map(|_| (rng.f32() - 0.5) * 0.02);
        for y in [-1.0, 1.0] {
            let (off, straight) = (square([x, y, z]), square([0.0, y, 0.0]));
            let apart = f64::from(off.right().dot(straight.right()));
            assert_that!(apart > 1.0_f64.to_radians().cos(), x, y, z, off);
            let lean = f64::from(off.right().dot(off.axis()));
            assert_that!(lean.abs() < 1e-6, x, y, z, off);
        }
    }
}

/// Rolls by quarter turns only exchange and negate components, so they turn a pattern exactly.
#[test]
fn quarters_of_a_turn_are_exact() {
    fn assert_turns<S: Format>() {
        let mut rng = Rng::with_seed(4);
        let light = spot([1.0, 2.0, 3.0], [0.3, -0.8, 0.4], 40.0);
        let exact = Square::stored::<S, _, _>(&light, 20.0, 0.0);
        let compiled = |degrees| rolled(&light, degrees).and_then(|s| s.compile::<S>()).expect("held");
        assert_eq!(compiled(0.0), Projection::of(&light).and_then(|s| s.compile()).expect("held"));
        for full in [-360.0, 360.0] {
            assert_eq!(compiled(full), compiled(0.0));
        }
        for (from, to) in [(0.0, 90.0), (90.0, 180.0), (180.0, 270.0), (-90.0, 0.0), (30.0, 120.0)] {
            let (from, to) = (compiled(from), compiled(to));
            for _ in 0..10_000 {
                let place = [rng.f64(), rng.f64(), 3.0];
                let point = sweep::single(exact.point(place)).map(S::length);
                let (before, after) = (from.project(point), to.project(point));
                // A row counted from the top becomes a column counted from the left, and a column
                // becomes a row counted from the bottom, which is rounded in the other direction.
                assert_that!((after.column - before.row).abs() <= 1, before, after);
                assert_that!((after.row - (65_535 - before.column)).abs() <= 1, before, after);
                assert_eq!(before.depth, after.depth);
            }
        }
    }
    in_every_format!(assert_turns);
}

/// Off the square a position is exact up to a distance of one side, and saturates there.
#[test]
fn places_off_the_square_are_off_it() {
    fn assert_off<S: Format>() {
        let mut rng = Rng::with_seed(9);
        for half_degrees in [1.0, 7.5, 30.0, 80.0] {
            let light = spot([1.0, 2.0, 3.0], [0.3, -0.8, 0.4], 2.0 * half_degrees);
            let compiled = Projection::of(&light).and_then(|square| square.compile::<S>()).expect("held");
            let exact = Square::stored::<S, _, _>(&light, half_degrees.into(), 0.0);
            for _ in 0..20_000 {
                let direction = sweep::direction(&mut rng);
                let point = exact.position + 4.0 * direction;
                let point = sweep::single(point).map(S::length);
                let [column, row, depth] = exact.project(S::exact_point(point));
                let place = compiled.project(point);
                let is_inside = |margin: f64| {
                    depth > 0.0 && [column, row].iter().all(|place| (-margin..1.0 + margin).contains(place))
                };
                if is_inside(-2e-3) || !is_inside(2e-3) {
                    assert_eq!(place.is_inside(), is_inside(0.0), "{point:?} {place:?}");
                }
            }
        }
    }
    in_every_format!(assert_off);
}

/// A format whose frames can be built from any bits.
trait Raw: Format {
    fn any_frame(rng: &mut Rng) -> Self::Frame;
}

macro_rules! raw {
    ($($format:ty: $frame:ident)*) => {$(
        impl Raw for $format {
            fn any_frame(rng: &mut Rng) -> Self::Frame {
                $frame::from_bits(std::array::from_fn(|_| bits(rng) as _))
            }
        }
    )*};
}

raw!(f32: FloatFrame Fx32: Frame32 Fx16: Frame16);

fn assert_sound<S: Format>(place: ProjectedPoint<S>) {
    let range = -65_536..=131_071;
    assert!(
        range.contains(&place.column) && range.contains(&place.row),
        "{place:?}, expected both in {range:?}"
    );
    assert_eq!(
        place.is_inside(),
        (0..65_536).contains(&place.column) && (0..65_536).contains(&place.row),
        "{place:?}"
    );
}

/// Every point has a position, also with a frame of any bits.
#[test]
fn every_bit_pattern_has_a_place() {
    fn assert_answers<S: Raw>() {
        let mut rng = Rng::with_seed(0xb175);
        for _ in 0..2_000 * sweep::effort() {
            let frame = S::any_frame(&mut rng);
            let any = CompiledProjection::<S>::from_parts(vector(&mut rng, S::length_from_bits), frame);
            let cone = Cone::from_outer(Step, Angle::degrees(160.0 - 155.0 * rng.f32())).expect("sound");
            let light = sweep::spot(&mut rng, cone);
            let real = Projection::of(&light).and_then(|square| square.compile::<S>()).expect("held");
            for _ in 0..20 {
                let point = vector(&mut rng, S::length_from_bits);
                assert_sound(any.project(point));
                let place = real.project(point);
                assert_sound(place);
                let depth = S::exact_length(place.depth);
                assert_that!((0.0..f64::INFINITY).contains(&depth), point, place);
            }
        }
    }
    in_every_format!(assert_answers);
}

/// Points on or behind the light, and NaN, are off the square, at depth 0.
#[test]
fn what_has_no_place_is_off_the_square() {
    fn assert_none<S: Format>(points: &[[f32; 3]]) {
        let light = spot([0.0, 0.0, 2.0], [0.0, 0.0, -1.0], 160.0);
        let compiled = Projection::of(&light).and_then(|square| square.compile::<S>()).expect("held");
        for &[x, y, z] in points {
            let place = compiled.project(Vec3::new(x, y, z).map(S::length));
            assert_that!(!place.is_inside(), x, y, z, place);
            assert_eq!(place.depth, S::Length::default());
        }
    }
    let points = [[0.0, 0.0, 2.0], [0.0, 0.0, 3.0], [1.0, 0.0, 2.0], [0.0, -5.0, 9.0]];
    in_every_format!(assert_none(&points));
    assert_none::<f32>(&[[f32::NAN, 0.0, 0.0], [0.0, 0.0, f32::NEG_INFINITY], [f32::NAN; 3]]);
    // On the axis of a light that points down, and as far away as numbers allow.
    let square = square([0.0, -1.0, 0.0]).compile::<f32>().expect("held");
    assert!(square.project(Vec3::new(0.0, -1e30, 0.0)).is_inside());
    assert!(!square.project(Vec3::new(f32::INFINITY, -1.0, 0.0)).is_inside());
}

/// The square encloses the lit part of the cone: a cutoff, as in OpenGL's cones, makes it smaller.
#[test]
fn a_square_is_that_of_the_cutoff() {
    let cone = Cone::<Power<8>>::opengl(sweep::half(30.0)).expect("sound");
    let spot = SpotLight::new(Vec3::default(), Vec3::new(0.0, -1.0, 0.0), cone).expect("sound");
    let tangent = Projection::of(&spot).expect("not too wide").tangent();
    assert_that!((tangent - 0.577_350).abs() < 1e-6, tangent);
}

#[test]
fn what_no_square_can_be() {
    let message = |refused: Result<Projection, Error>| refused.expect_err("no such square").to_string();
    assert_eq!(
        message(Projection::of(&spot([0.0; 3], [0.0, 1.0, 0.0], 160.1))),
        "outer angle = 160.1: expected more than 0 and at most 160 degrees (full angle)"
    );
    let widest = spot([0.0; 3], [0.0, 1.0, 0.0], 160.0);
    let square = Projection::of(&widest).expect("the limit itself is accepted");
    for (roll, shown) in [(360.5, "360.5"), (f32::NAN, "NaN"), (f32::INFINITY, "inf")] {
        assert_eq!(
            message(square.turned(Angle::degrees(roll))),
            format!("roll = {shown}: expected a finite number from -360 to 360 degrees")
        );
    }
    let narrow = Projection::of(&spot([0.0; 3], [0.0, 1.0, 0.0], 0.5)).expect("a sound square");
    let refused = narrow.compile::<Fx16>().expect_err("too narrow for 16 bits");
    let narrowest = Cone::narrowest::<Fx16>(Step).to_degrees();
    assert_eq!(
        (refused.parameter, refused.accepted),
        (Parameter::OuterAngle, Expected::AngleFrom(narrowest))
    );
    assert!(narrow.compile::<f32>().is_ok() && narrow.compile::<Fx32>().is_ok());
    let far = Projection::of(&spot([0.0, 0.0, 20_000.0], [0.0, 1.0, 0.0], 40.0)).expect("a sound square");
    assert_eq!(far.compile::<Fx16>().expect_err("too far").parameter, Parameter::Position);
    assert_eq!(far.position().z, 20_000.0);
}
