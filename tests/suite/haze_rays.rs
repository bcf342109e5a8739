//! In-scattering along view rays where its evaluation branches, against the oracle.
//!
//! `cargo test --test suite haze_rays:: -- --nocapture` prints the largest errors.

use fastrand::Rng;
use luminaire::{
    Cone, SpotLight, Vec3,
    attenuation::{Attenuation, FilamentRange, InverseSquare, SmoothRange},
    falloff::{Falloff, Hard, Soft, Step, Table},
    haze::{BeamScattering, Haze, ViewRay},
};
use support::{
    assert_that,
    in_scattering::Beam,
    oracle::{self, DVec3},
    sweep,
    views::{distances, exact, exactly, near_beam, view},
};

const LIGHT: Vec3<f32> = Vec3::new(1.0, 4.0, -2.0);
const RANGE: f32 = 6.0;

/// Axes along a coordinate and between them.
const AXES: [Vec3<f32>; 2] = [Vec3::new(0.0, -1.0, 0.0), Vec3::new(0.36, -0.8, 0.48)];

/// A light, and its haze in both models.
fn beam<P: Falloff, A: Attenuation>(
    spot: SpotLight<P, A>,
    exact_profile: fn(f64) -> f64,
    exact_attenuation: oracle::Attenuation,
) -> (BeamScattering<P, A>, Beam) {
    let haze = Haze::new(1.0).expect("a sound density");
    let stored = oracle::Cone::new(exact_profile, spot.cone().outer_versine().into());
    let exact_spot = oracle::SpotLight::new(exact(spot.position()), exact(spot.axis()), stored);
    let beam = Beam {
        spot: oracle::SpotLight { attenuation: exact_attenuation, ..exact_spot },
        range: spot.attenuation().range().map_or(f64::INFINITY, f64::from),
        density: 1.0,
        source_radius: haze.source_radius().into(),
    };
    (spot.compile::<f32>().expect("held").in_haze(&haze), beam)
}

/// The largest error along rays at beams of every width, and how many rays are lit. Errors are
/// relative to the in-scattering or, if that is more, to `share` of the in-scattering along a line
/// across the axis at the same distance from the light.
fn largest_error<P: Falloff, A: Attenuation>(
    falloff: (P, fn(f64) -> f64),
    attenuation: (A, oracle::Attenuation),
    share: f64,
    rays: impl Fn(&mut Rng, &Beam) -> Vec<ViewRay>,
    evaluated: impl Fn(&BeamScattering<P, A>, &Beam, &ViewRay) -> (f32, f64),
) -> (f64, u32) {
    let (mut worst, mut lit, mut rng) = (0.0_f64, 0, Rng::with_seed(68));
    for (half, axis) in [2.0, 20.0, 60.0, 88.0].into_iter().flat_map(|half| AXES.map(|axis| (half, axis))) {
        let cone = Cone::from_outer(falloff.0, sweep::half(half)).expect("a sound cone");
        let spot = SpotLight::new(LIGHT, axis, cone).expect("a sound light").with_attenuation(attenuation.0);
        let (compiled, beam) = beam(spot, falloff.1, attenuation.1);
        let across = share * beam.across();
        for view in rays(&mut rng, &beam) {
            let (nearest, height) = distances(&beam, &exactly(&view));
            // At the rim of the light's body the light jumps.
            if (0.9..1.1).contains(&(height / beam.source_radius)) {
                continue;
            }
            let (found, exact) = evaluated(&compiled, &beam, &view);
            let unit = exact.max(across * nearest * beam.spot.attenuation.at(nearest)).max(1e-30);
            worst = worst.max((f64::from(found) - exact).abs() / unit);
            lit += u32::from(exact > 0.0);
        }
    }
    (worst, lit)
}

/// The in-scattering in both models.
fn in_scattering<P: Falloff, A: Attenuation>(
    compiled: &BeamScattering<P, A>,
    beam: &Beam,
    view: &ViewRay,
) -> (f32, f64) {
    (compiled.in_scattering(view), beam.in_scattering(&exactly(view)))
}

/// The same past something that lets through more and less of the light, by 512 samples.
fn sampled<P: Falloff, A: Attenuation>(
    compiled: &BeamScattering<P, A>,
    beam: &Beam,
    view: &ViewRay,
) -> (f32, f64) {
    let waves = |point: DVec3| 0.5 + 0.5 * point.dot(DVec3::new(0.9, 1.5, -0.6)).sin();
    let found = compiled.in_scattering_through(view, 512, |point| waves(exact(point)) as f32);
    (found, beam.in_scattering_through(&exactly(view), waves))
}

fn smooth() -> (SmoothRange, oracle::Attenuation) {
    let smooth = SmoothRange::new(RANGE).expect("a sound range");
    (smooth, oracle::Attenuation::SmoothRange(RANGE.into()))
}

fn filament() -> (FilamentRange, oracle::Attenuation) {
    let ranged = FilamentRange::new(InverseSquare, Some(RANGE)).expect("a sound range");
    (ranged, oracle::Attenuation::FilamentRange(RANGE.into()))
}

const SOFT: (Soft, fn(f64) -> f64) = (Soft, oracle::soft);
const HARD: (Hard, fn(f64) -> f64) = (Hard, oracle::hard);
const STEP: (Step, fn(f64) -> f64) = (Step, oracle::step);
const INVERSE_SQUARE: (InverseSquare, oracle::Attenuation) =
    (InverseSquare, oracle::Attenuation::InverseSquare);

fn assert_within<const N: usize>(found: [(f64, u32); N], bounds: [f64; N], least_lit: u32) {
    println!("{found:?} within {bounds:?}");
    for ((error, lit), bound) in found.into_iter().zip(bounds) {
        assert!(error <= bound, "{error:.1e} over {bound:.1e}");
        assert!(lit >= least_lit, "only {lit} rays are lit");
    }
}

/// A falloff that is steep at its edge, a step, and a peak next to the axis, which the oracle
/// itself integrates in few steps.
#[test]
fn rays_at_other_beams_keep_their_error() {
    const fn peak<const N: usize>() -> [u16; N] {
        let mut samples = [0; N];
        samples[0] = u16::MAX;
        samples
    }
    const PEAK: [u16; 513] = peak();
    const WIDER: [u16; 201] = peak();
    let peak = (Table::of(&PEAK), (|t| (1.0 - 512.0 * (1.0 - t)).max(0.0)) as fn(f64) -> f64);
    let wider = (Table::of(&WIDER), (|t| (1.0 - 200.0 * (1.0 - t)).max(0.0)) as fn(f64) -> f64);
    let rays = |rng: &mut Rng, beam: &Beam| (0..40).map(|_| view(rng, beam)).collect();
    let found = [
        largest_error(HARD, INVERSE_SQUARE, 1.0, rays, in_scattering),
        largest_error(STEP, INVERSE_SQUARE, 1.0, rays, in_scattering),
        largest_error(peak, INVERSE_SQUARE, 1.0, rays, in_scattering),
        largest_error(wider, INVERSE_SQUARE, 1.0, rays, in_scattering),
        largest_error(HARD, smooth(), 1.0, rays, in_scattering),
        largest_error(STEP, smooth(), 1.0, rays, in_scattering),
    ];
    assert_within(found, [1e-5, 5e-5, 0.1, 0.1, 2.8e-3, 2.6e-3], 30);
}

/// The samples of a transmittance are where it has its part in the light.
#[test]
fn sampled_rays_keep_their_error() {
    let rays = |rng: &mut Rng, beam: &Beam| {
        let view = |rng: &mut Rng| view(rng, beam);
        (0..40).map(|_| view(rng)).map(|view| ViewRay { length: view.length.min(20.0), ..view }).collect()
    };
    let found = [
        largest_error(SOFT, INVERSE_SQUARE, 1.0, rays, sampled),
        largest_error(SOFT, smooth(), 1.0, rays, sampled),
        largest_error(SOFT, filament(), 1.0, rays, sampled),
    ];
    assert_within(found, [2.5e-4, 1.4e-5, 2e-5], 100);
}

/// Short rays in the middle of a beam, across it and nearly along it: their arcs have ends with the
/// same leading bits. Errors are relative to the ray's own light.
#[test]
fn short_rays_keep_their_error() {
    let short = |rng: &mut Rng, beam: &Beam| {
        let eye = sweep::single(near_beam(rng, &beam.spot, 0.5));
        let way = exact(eye) - beam.spot.position;
        let off = 0.2 * 0.05_f64.powf(rng.f64());
        let along = sweep::direction_off(rng, way.normalize(), off);
        let direction = [sweep::direction(rng), along, -along][rng.usize(..3)];
        let width = beam.spot.cone.limit.sqrt() * way.length();
        ViewRay {
            eye,
            direction: sweep::single(direction),
            length: (0.3 * width * 0.05_f64.powf(rng.f64())) as f32,
        }
    };
    let rays = |rng: &mut Rng, beam: &Beam| (0..60).map(|_| short(rng, beam)).collect();
    let found = [
        largest_error(SOFT, INVERSE_SQUARE, 0.0, rays, in_scattering),
        largest_error(SOFT, smooth(), 0.0, rays, in_scattering),
        largest_error(SOFT, filament(), 0.0, rays, in_scattering),
    ];
    assert_within(found, [1.4e-4, 3.4e-4, 1e-3], 100);
}

/// An eye on the surface of the light sees nothing into the light, and the whole beam away from it.
#[test]
fn an_eye_on_the_light_sees_away_from_it() {
    let cone = Cone::from_outer(Soft, sweep::half(20.0)).expect("a sound cone");
    let haze = Haze::new(1.0).and_then(|haze| haze.with_source_radius(0.5)).expect("sound");
    let down = Vec3::new(0.0, -1.0, 0.0);
    let spot = SpotLight::new(LIGHT, down, cone).expect("a sound light");
    let beam = spot.compile::<f32>().expect("held").in_haze(&haze);
    let light = |above: f32, direction| {
        let eye = Vec3::new(LIGHT.x, LIGHT.y + above, LIGHT.z);
        beam.in_scattering(&ViewRay::endless(eye, direction))
    };
    assert_eq!(light(0.5, down), 0.0);
    assert_eq!(light(-0.5, Vec3::new(0.0, 1.0, 0.0)), 0.0);
    // A quarter of the integral of `1 / d^2` from 0.5 on.
    assert_that!((light(-0.5, down) - 0.5).abs() < 1e-6, light(-0.5, down));
    // The smallest light hides the haze behind it, too.
    let haze = Haze::new(1.0).and_then(|haze| haze.with_source_radius(1e-3)).expect("sound");
    let beam = spot.compile::<f32>().expect("held").in_haze(&haze);
    let eye = Vec3::new(LIGHT.x, LIGHT.y + 1.0, LIGHT.z);
    assert_eq!(beam.in_scattering(&ViewRay::endless(eye, down)), 0.0);
}
