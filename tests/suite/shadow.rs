//! Shadow maps: their visibility compared with f64, and the points where it is exact.

use fastrand::Rng;
use luminaire::number::Arithmetic;
use luminaire::{
    Angle, Cone, Error, Fx16, Fx32, Scalar, Vec3,
    error::{Expected, Parameter},
    falloff::Step,
    projector::{CompiledProjection, ProjectedPoint, Projection, Shadow},
};
use support::{
    arbitrary::{bits, vector},
    assert_that,
    format::Format,
    in_every_format, shadows, sweep,
};

/// Range of the largest error of a visibility, compared with f64 at the same position (searched).
/// Two interpolation weights are truncated to multiples of 1/128, so that the error is at most 1 -
/// (1 - 1 / 128)^2.
const ERROR: std::ops::Range<f64> = 0.0138..0.015_57;

fn projection<S: Scalar>(rng: &mut Rng) -> CompiledProjection<S> {
    let cone = Cone::from_outer(Step, Angle::degrees(60.0)).expect("sound");
    Projection::of(&sweep::spot(rng, cone)).and_then(|square| square.compile()).expect("held")
}

fn random<S: Scalar>(rng: &mut Rng, side: usize) -> Vec<S::Length> {
    (0..side * side).map(|_| S::length(1.0 + (rng.f32() * 8.0).round())).collect()
}

/// The largest error of a visibility, at random positions on maps with sides from 1 to 40.
fn error<S: Format>() -> f64 {
    let mut rng = Rng::with_seed(12);
    let mut worst = 0.0_f64;
    for side in 1..=40 {
        let depths = random::<S>(&mut rng, side);
        let exact: Vec<_> = depths.iter().map(|&depth| S::exact_length(depth)).collect();
        let shadow = Shadow::<S>::new(projection(&mut rng), side, &depths).expect("a square of them");
        for _ in 0..4_000 * sweep::effort() {
            let (column, row) = (rng.i32(0..65_536), rng.i32(0..65_536));
            let depth = S::length((rng.f32() * 40.0).round() / 4.0);
            let place = [column, row].map(|steps| f64::from(steps) / 65_536.0);
            let exact = shadows::visibility(side, &exact, place, S::exact_length(depth));
            worst = worst.max((shadow.at(&ProjectedPoint { column, row, depth }).exact() - exact).abs());
        }
    }
    worst
}

#[test]
fn visibilities_keep_their_row() {
    for (format, error) in [("f32", error::<f32>()), ("fx32", error::<Fx32>()), ("fx16", error::<Fx16>())] {
        println!("{format}: {error:.5}");
        assert_that!(ERROR.contains(&error), format, error);
    }
    for steps in -16_384..=16_384 {
        let exact = f64::from(steps) / 16_384.0;
        assert_eq!(
            [
                f32::from_steps(steps).exact(),
                Fx32::from_steps(steps).exact(),
                Fx16::from_steps(steps).exact()
            ],
            [exact; 3]
        );
    }
}

/// Asserts that the visibility is exactly 1 where no texel is nearer than the point, and exactly 0
/// where every texel is nearer, on the projection and off it. Behind the light it is 1.
fn assert_exact_ends<S: Format>() {
    let mut rng = Rng::with_seed(13);
    for side in [1, 2, 3, 16, 100, 2048] {
        let depth = S::length(5.0);
        let (below, beyond) = (S::length(4.999), S::length(f32::INFINITY));
        for (limit, expected) in [(depth, S::ONE), (beyond, S::ONE), (below, S::ZERO)] {
            let depths = vec![limit; side * side];
            let shadow = Shadow::<S>::new(projection(&mut rng), side, &depths).expect("a square of them");
            for _ in 0..2_000 {
                let place = ProjectedPoint { column: rng.i32(0..65_536), row: rng.i32(0..65_536), depth };
                assert_eq!(shadow.at(&place), expected, "{place:?}");
            }
            for (column, row) in [(-1, 9), (9, -1), (65_536, 9), (9, 65_536), (i32::MIN, i32::MAX)] {
                assert_eq!(shadow.at(&ProjectedPoint { column, row, depth }), expected, "off the square");
                let behind = ProjectedPoint { column, row, depth: S::Length::default() };
                assert_eq!(shadow.at(&behind), S::ONE, "behind the light");
            }
        }
    }
}

#[test]
fn light_that_nothing_hides_and_full_shadow_are_exact() {
    in_every_format!(assert_exact_ends);
}

fn assert_point_is_place<S: Format>() {
    let mut rng = Rng::with_seed(15);
    let depths = random::<S>(&mut rng, 64);
    let mut partial = 0;
    for _ in 0..20 {
        let shadow = Shadow::<S>::new(projection(&mut rng), 64, &depths).expect("a square of them");
        for _ in 0..2_000 {
            let point = Vec3::new(rng.f32(), rng.f32(), rng.f32()).map(|c| S::length(20.0 * c - 10.0));
            let visibility = shadow.visibility(point);
            assert_eq!(visibility, shadow.at(&shadow.projection().project(point)));
            partial += usize::from(visibility > S::ZERO && visibility < S::ONE);
        }
    }
    assert!(partial > 100, "{partial} points are between light and shadow");
}

#[test]
fn a_point_has_the_visibility_of_its_place() {
    in_every_format!(assert_point_is_place);
}

fn assert_any_bits<S: Format>() {
    let mut rng = Rng::with_seed(16);
    for _ in 0..2_000 * sweep::effort() {
        let depths: Vec<_> = (0..rng.usize(..40)).map(|_| S::length_from_bits(bits(&mut rng))).collect();
        let side = if rng.bool() { rng.u32(..8) } else { bits(&mut rng) as u32 };
        let shadow = Shadow::<S>::from_parts(projection(&mut rng), side, &depths);
        for _ in 0..20 {
            let steps = if rng.bool() { 65_535 } else { u64::MAX };
            let [column, row] = [(); 2].map(|()| (bits(&mut rng) & steps) as i32);
            let place = ProjectedPoint { column, row, depth: S::length_from_bits(bits(&mut rng)) };
            let point = vector(&mut rng, S::length_from_bits);
            for visibility in [shadow.at(&place), shadow.visibility(point)] {
                assert_that!((0.0..=1.0).contains(&visibility.exact()), shadow, place, point);
            }
        }
    }
}

#[test]
fn any_bits_have_a_visibility() {
    in_every_format!(assert_any_bits);
}

/// In floating point a point of NaN depth is not in shadow, and a NaN texel casts no shadow.
#[test]
fn what_is_not_a_number_is_not_in_shadow() {
    let mut rng = Rng::with_seed(17);
    for (limit, depth) in [(f32::NAN, 1.0), (1.0, f32::NAN)] {
        let depths = [limit; 4];
        let shadow = Shadow::<f32>::new(projection(&mut rng), 2, &depths).expect("a square of them");
        assert_eq!(shadow.at(&ProjectedPoint { column: 1, row: 2, depth }), 1.0);
    }
}

#[test]
fn a_texel_that_is_missing_hides_nothing() {
    let projection = projection::<f32>(&mut Rng::with_seed(20));
    let depths = [1.0; 3];
    for (row, expected) in [(16_384, 0.0), (32_768, 0.25), (49_151, 0.5)] {
        let place = ProjectedPoint { column: 32_768, row, depth: 2.0 };
        let visibility = Shadow::<f32>::from_parts(projection, 2, &depths).at(&place);
        assert!((visibility - expected).abs() < 1e-2, "{visibility} at row {row}");
    }
}

#[test]
fn maps_that_are_no_square_are_refused() {
    let projection = projection::<f32>(&mut Rng::with_seed(19));
    let refused = |side, count| Shadow::new(projection, side, &vec![1.0; count]).expect_err("no square");
    for side in [0, 4_097] {
        let accepted = Expected::WholeBetween(1, 4_096);
        assert_eq!(refused(side, 16), Error { parameter: Parameter::Side, value: side as f32, accepted });
    }
    let error = refused(4, 15);
    assert_eq!(error.parameter, Parameter::SampleCount);
    assert_eq!(error.to_string(), "number of samples = 15: expected 16");
}
