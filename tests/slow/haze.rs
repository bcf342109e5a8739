//! Air light in haze against the oracle, row by row of `tests/bounds.csv`, and the laws that it
//! keeps.
//!
//! `cargo test --test slow haze:: -- --nocapture --test-threads 1` prints the measured rows.

use fastrand::Rng;
use luminaire::{
    SpotLight,
    attenuation::{
        Attenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
        Windowed,
    },
    falloff::{Falloff, Power, Soft},
    haze::{BeamScattering, Haze, ViewRay},
};
use support::{
    bounds,
    falloffs::Shape,
    haze::HALF_ANGLES,
    in_scattering::Beam,
    oracle::{self, DVec3},
    sweep,
    views::{distances, exactly, view},
    with_every_shape,
};

const DENSITY: f32 = 0.5;

/// A spotlight in haze, and its exact model.
struct Pair<P: Falloff, A: Attenuation> {
    kernel: BeamScattering<P, A>,
    oracle: Beam,
    across: f64,
}

fn haze() -> Haze {
    Haze::new(DENSITY).expect("a sound density")
}

fn pair<P: Falloff, A: Attenuation>(
    spot: SpotLight<P, A>,
    cone: oracle::Cone,
    attenuation: oracle::Attenuation,
    range: f64,
) -> Pair<P, A> {
    let oracle = Beam {
        spot: oracle::SpotLight { attenuation, ..sweep::stored::<f32, _, _>(&spot, cone) },
        range,
        density: DENSITY.into(),
        source_radius: haze().source_radius().into(),
    };
    let across = oracle.across();
    Pair { kernel: spot.compile::<f32>().expect("held").in_haze(&haze()), oracle, across }
}

/// The error of a ray, relative to what is seen there or to what a line across the axis sees that
/// is as near to the light, whichever is more. At the rim of the light's body there is none: the
/// light jumps, and no format can place the jump.
fn error<P: Falloff, A: Attenuation>(
    pair: &Pair<P, A>,
    view: &ViewRay,
    found: f32,
    transmission: impl Fn(DVec3) -> f64,
) -> f64 {
    let ray = exactly(view);
    let (nearest, height) = distances(&pair.oracle, &ray);
    if (0.9..1.1).contains(&(height / pair.oracle.source_radius)) {
        return 0.0;
    }
    let truth = pair.oracle.in_scattering_through(&ray, transmission);
    let across = pair.across * nearest * pair.oracle.spot.attenuation.at(nearest);
    let error = (f64::from(found) - truth).abs();
    // Where there is no light there is no error either.
    if error == 0.0 { 0.0 } else { oracle::counted(error / truth.max(across)) }
}

/// The largest error over 1,800 rays, the same in every run.
fn largest<P: Falloff, A: Attenuation>(
    pair: impl Fn(&mut Rng) -> Pair<P, A>,
    mut error: impl FnMut(&mut Rng, &Pair<P, A>) -> f64,
) -> f64 {
    let mut rng = Rng::with_seed(4);
    let mut worst = 0.0_f64;
    for _ in 0..60 {
        let pair = pair(&mut rng);
        for _ in 0..30 {
            worst = worst.max(error(&mut rng, &pair));
        }
    }
    worst
}

fn shaped<P: Falloff>(rng: &mut Rng, shape: &Shape<P>, half: f32) -> Pair<P, InverseSquare> {
    pair(
        sweep::spot(rng, shape.at(half)),
        shape.stored_at(half),
        oracle::Attenuation::InverseSquare,
        f64::INFINITY,
    )
}

fn cones_broken<P: Falloff>(shape: &Shape<P>) -> Vec<String> {
    if bounds::is_left_out(shape.name) {
        return Vec::new();
    }
    let measured = HALF_ANGLES.map(|half| {
        largest(
            |rng| shaped(rng, shape, half),
            |rng, pair| {
                let view = view(rng, &pair.oracle);
                error(pair, &view, pair.kernel.in_scattering(&view), |_| 1.0)
            },
        )
    });
    println!("{:16} {}", shape.name, measured.map(|e| format!("{e:.1e}")).join(", "));
    bounds::broken("haze", shape.name, "f32", &measured)
}

#[test]
fn every_cone_keeps_its_row() {
    let mut broken: Vec<_> = with_every_shape!(cones_broken -> Vec<String>).into_iter().flatten().collect();
    let shape = Shape::plain("power-128", Power::<128>, |t| t.powi(128));
    broken.extend(cones_broken(&shape));
    bounds::assert_kept(&broken);
}

/// The largest errors of a distance model, along rays that end.
fn distance_broken<A: Attenuation>(
    name: &str,
    attenuation: A,
    range: f64,
    oracle: oracle::Attenuation,
) -> Vec<String> {
    let shape = Shape::plain("soft", Soft, oracle::soft);
    let measured = HALF_ANGLES.map(|half| {
        largest(
            |rng| {
                let spot = sweep::spot(rng, shape.at(half)).with_attenuation(attenuation);
                pair(spot, shape.stored_at(half), oracle, range)
            },
            |rng, pair| {
                let view = view(rng, &pair.oracle);
                let view = ViewRay { length: view.length.min(30.0), ..view };
                error(pair, &view, pair.kernel.in_scattering(&view), |_| 1.0)
            },
        )
    });
    println!("{name:16} {}", bounds::shown(&measured));
    bounds::broken("haze attenuation", name, "f32", &measured)
}

#[test]
fn every_distance_model_keeps_its_row() {
    const RANGE: f32 = 6.0;
    let (sound, range, none) = ("a sound model", f64::from(RANGE), f64::INFINITY);
    let polynomial = Polynomial::new(0.5, 0.25, 0.125).expect(sound);
    let smooth = SmoothRange::new(RANGE).expect(sound);
    let gltf = GltfRange::new(InverseSquare, Some(RANGE)).expect(sound);
    let filament = FilamentRange::new(InverseSquare, Some(RANGE)).expect(sound);
    let cut = CutAt::new(InverseSquare, Some(RANGE)).expect(sound);
    let windowed = Windowed::new(InverseSquare, Some(RANGE)).expect(sound);
    let broken = [
        distance_broken("unattenuated", NoAttenuation, none, oracle::Attenuation::None),
        distance_broken("polynomial", polynomial, none, oracle::Attenuation::Polynomial([0.5, 0.25, 0.125])),
        distance_broken("smooth range", smooth, range, oracle::Attenuation::SmoothRange(range)),
        distance_broken("glTF range", gltf, range, oracle::Attenuation::GltfRange(range)),
        distance_broken("Filament range", filament, range, oracle::Attenuation::FilamentRange(range)),
        distance_broken("windowed", windowed, range, oracle::Attenuation::FilamentRange(range)),
        distance_broken("cut at", cut, range, oracle::Attenuation::InverseSquare),
    ]
    .concat();
    bounds::assert_kept(&broken);
}
