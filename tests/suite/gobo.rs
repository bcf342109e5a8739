//! Gobos: their transmittance compared with f64, and the points where it is exact.

use fastrand::Rng;
use luminaire::number::Arithmetic;
use luminaire::{
    Angle, Cone, Error, Fx16, Fx32, Scalar, SpotLight, Vec3,
    error::{Expected, Parameter},
    falloff::{Soft, Step},
    projector::{Gobo, ProjectedPoint, Projection},
};
use support::{
    arbitrary::{bits, vector},
    bounds::{self, REFUSE},
    every,
    format::Format,
    gobos::transmission,
    in_every_format,
    squares::Square,
    sweep,
};

/// The largest sum of weighted bytes: all weights, times 255.
const ALL: u32 = 255 << 24;

fn random(rng: &mut Rng, side: usize) -> Vec<u8> {
    (0..side * side).map(|_| if rng.bool() { rng.u8(..) } else { 255 * rng.u8(..2) }).collect()
}

fn at<S: Scalar>(column: i32, row: i32) -> ProjectedPoint<S> {
    ProjectedPoint { column, row, depth: S::Length::default() }
}

/// A random spotlight of this half angle, its projection, and the same projection in f64.
fn projection<S: Format>(rng: &mut Rng, half_degrees: f32) -> (SpotLight<Step>, Projection, Square) {
    let cone = Cone::from_outer(Step, sweep::half(half_degrees)).expect("sound");
    let spot = sweep::spot(rng, cone);
    let square = Square::stored::<S, _, _>(&spot, half_degrees.into(), 0.0);
    (spot, Projection::of(&spot).expect("not too wide"), square)
}

/// The largest error at random positions of the projection. The exact value is that at the middle
/// of the position's step.
fn error_of_places<S: Format>(side: usize) -> f64 {
    let mut rng = Rng::with_seed(7);
    let mut worst = 0.0_f64;
    for _ in 0..20 * sweep::effort() {
        let transmissions = random(&mut rng, side);
        let gobo = Gobo::new(side, &transmissions).expect("a square of them");
        for _ in 0..10_000 {
            let steps = [rng.i32(0..65_536), rng.i32(0..65_536)];
            let exact = transmission(side, &transmissions, steps.map(|s| (f64::from(s) + 0.5) / 65_536.0));
            let found: S = gobo.transmission(&at(steps[0], steps[1]));
            worst = worst.max((found.exact() - exact).abs());
        }
    }
    worst
}

/// The largest error at random points all over the projection.
fn error_of_points<S: Format>(side: usize, half_degrees: f32) -> f64 {
    let mut rng = Rng::with_seed(8);
    let mut worst = 0.0_f64;
    for _ in 0..50 * sweep::effort() {
        let (_, projection, square) = projection::<S>(&mut rng, half_degrees);
        let Ok(compiled) = projection.compile::<S>() else { return REFUSE };
        let transmissions = random(&mut rng, side);
        let gobo = Gobo::new(side, &transmissions).expect("a square of them").on(compiled);
        for _ in 0..4_000 {
            let place = [rng.f64(), rng.f64(), sweep::distance(&mut rng)];
            let point = sweep::single(sweep::on_grid(square.point(place))).map(S::length);
            let [column, row, _] = square.project(S::exact_point(point));
            let exact = transmission(side, &transmissions, [column, row]);
            worst = worst.max((gobo.at(point).exact() - exact).abs());
        }
    }
    worst
}

#[test]
fn transmissions_keep_their_rows() {
    for side in [7, 64, 256] {
        let measured =
            [error_of_places::<f32>(side), error_of_places::<Fx32>(side), error_of_places::<Fx16>(side)];
        bounds::assert_row("gobo", &format!("place side {side}"), measured);
    }
    for (name, half) in [
        ("0.1 degrees", 0.1),
        ("1 degree", 1.0),
        ("7.5 degrees", 7.5),
        ("30 degrees", 30.0),
        ("80 degrees", 80.0),
    ] {
        let measured = [
            error_of_points::<f32>(64, half),
            error_of_points::<Fx32>(64, half),
            error_of_points::<Fx16>(64, half),
        ];
        bounds::assert_row("gobo", &format!("{name} side 64"), measured);
    }
}

/// The conversion of a sum of weighted bytes to the format is exact at both ends, never falls, and
/// gives 1 for larger sums. Exhaustive with `LUMINAIRE_FULL`, else one sum in 1,009.
#[test]
fn weighted_bytes_keep_their_roundings() {
    fn assert_within<S: Format>(bound: f64) {
        let step = f64::from(S::STEP);
        let seen = every::input(S::NAME, 0..=u64::from(ALL), |sum| {
            [S::weighted_byte(sum as u32).exact() / step, sum as f64 / f64::from(ALL) / step]
        });
        println!("{:4} weighted byte {:.4} steps", S::NAME, seen.error);
        bounds::check(S::NAME, seen.error, bound).unwrap_or_else(|broken| panic!("{broken}"));
        assert_eq!(seen.fall, 0.0);
        assert_eq!((S::weighted_byte(0), S::weighted_byte(ALL)), (S::ZERO, S::ONE));
        for more in [ALL + 1, u32::MAX] {
            assert_eq!(S::weighted_byte(more), S::ONE);
        }
    }
    assert_within::<f32>(0.75);
    assert_within::<Fx32>(0.75);
    assert_within::<Fx16>(0.76);
}

/// A gobo whose texels are all equal has the same transmittance everywhere, bit-identical for every
/// size.
#[test]
fn an_even_pane_has_one_transmission() {
    fn assert_even<S: Format>() {
        let mut rng = Rng::with_seed(77);
        for side in [1, 2, 7, 32, 100] {
            let byte = rng.u8(..);
            let transmissions = vec![byte; side * side];
            let gobo = Gobo::new(side, &transmissions).expect("a square of them");
            for _ in 0..10_000 {
                let [column, row] = [0; 2].map(|_| bits(&mut rng) as i32);
                let found: S = gobo.transmission(&at(column, row));
                assert_eq!(found, S::weighted_byte(u32::from(byte) << 24), "{side}: {column} {row}");
            }
        }
    }
    in_every_format!(assert_even);
}

/// Outside the projection, and in the outer half of a border texel, the value of the border texel
/// continues.
#[test]
fn the_border_goes_on() {
    let mut rng = Rng::with_seed(31);
    let transmissions = random(&mut rng, 8);
    let gobo = Gobo::new(8, &transmissions).expect("a square of them");
    for _ in 0..10_000 {
        let [column, row] = [0; 2].map(|_| bits(&mut rng) as i32);
        // From the centre of the first texel to the centre of the last.
        let [nearest_column, nearest_row] = [column, row].map(|steps| steps.clamp(4_096, 61_440));
        let found: Fx32 = gobo.transmission(&at(column, row));
        let nearest = gobo.transmission(&at::<Fx32>(nearest_column, nearest_row));
        assert_eq!(found, nearest, "{column} {row}");
    }
}

/// At every point of any bits, a gobo of transmittance 1 changes no bit of the light, and a gobo of
/// transmittance 0 passes none.
#[test]
fn clear_glass_changes_no_bit() {
    fn assert_clear<S: Format>() {
        let mut rng = Rng::with_seed(255);
        let (clear, shut) = (Gobo::of(&[255; 25]), Gobo::of(&[0; 25]));
        let mut lit = 0;
        for _ in 0..200 * sweep::effort() {
            let half_degrees = 2.0 + 70.0 * rng.f32();
            let (spot, projection, square) = projection::<S>(&mut rng, half_degrees);
            let compiled = projection.compile::<S>().expect("held");
            let light = spot.with_intensity(64.0).and_then(|spot| spot.compile::<S>()).expect("held");
            for _ in 0..100 {
                let near = sweep::single(square.point([rng.f64(), rng.f64(), 4.0])).map(S::length);
                let normal = sweep::single(sweep::direction(&mut rng)).map(S::from_f32);
                for (point, normal) in [
                    (near, normal),
                    (vector(&mut rng, S::length_from_bits), vector(&mut rng, S::scalar_from_bits)),
                ] {
                    let arriving = light.irradiance(point, normal);
                    assert_eq!(clear.on(compiled).at(point), S::ONE);
                    assert_eq!(clear.on(compiled).filter(arriving, point), arriving);
                    assert_eq!(shut.on(compiled).at(point), S::ZERO);
                    assert_eq!(shut.on(compiled).filter(arriving, point), S::Irradiance::default());
                    lit += u32::from(arriving > S::Irradiance::default());
                }
            }
        }
        assert!(lit > 5_000, "only {lit} points are lit");
    }
    in_every_format!(assert_clear);
}

/// A gobo appears on a wall as stored, seen from behind the light: the first row is at the top, and
/// the first column at the left.
#[test]
fn a_pattern_stands_upright_on_a_wall() {
    let cone = Cone::from_outer(Soft, Angle::degrees(90.0)).expect("sound");
    let spot = SpotLight::new(Vec3::default(), Vec3::new(0.0, 0.0, -1.0), cone).expect("sound");
    let square = Projection::of(&spot).and_then(|square| square.compile::<f32>()).expect("held");
    let gobo = Gobo::of(&[255, 0, 0, 0]).on(square);
    let corners = [(-1.0, 1.0), (1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    assert_eq!(corners.map(|(x, y)| gobo.at(Vec3::new(x, y, -1.0))), [1.0, 0.0, 0.0, 0.0]);
}

#[test]
fn what_is_no_gobo() {
    let message = |refused: Result<Gobo<'_>, Error>| refused.expect_err("no gobo").to_string();
    assert_eq!(message(Gobo::new(0, &[])), "side = 0: expected a whole number from 1 to 4096");
    assert_eq!(message(Gobo::new(4_097, &[])), "side = 4097: expected a whole number from 1 to 4096");
    assert_eq!(message(Gobo::new(3, &[0; 8])), "number of samples = 8: expected 9");
    let refused = Gobo::new(usize::MAX, &[]).expect_err("no gobo");
    assert_eq!((refused.parameter, refused.accepted), (Parameter::Side, Expected::WholeBetween(1, 4_096)));
    let widest = vec![9; 4_096 * 4_096];
    let gobo = Gobo::new(4_096, &widest).expect("the limit itself is accepted");
    let found: Fx32 = gobo.transmission(&at(65_535, 65_535));
    assert_eq!(found, Fx32::weighted_byte(9 << 24));
}
