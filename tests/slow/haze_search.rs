//! Air light searched where the arc that a light sees of a view ray is nearly degenerate: half of
//! all rays are within 0.01 rad of a critical direction.
//!
//! `LUMINAIRE_FULL=1 cargo test --test slow haze_search:: -- --nocapture --test-threads 1` compares
//! 10^6 rays with the oracle.

use fastrand::Rng;
use luminaire::{
    Cone, HalfAngle,
    attenuation::{AnyAttenuation, Attenuation, FilamentRange, InverseSquare},
    falloff::{AnyFalloff, Soft},
    haze::{BeamScattering, Haze, RayBundle, ViewRay, ViewRays},
};
use std::{
    sync::{
        Mutex,
        atomic::{AtomicU64, Ordering},
    },
    thread,
};
use support::{
    bounds,
    critical::Frame,
    every::is_full,
    haze::HALF_ANGLES,
    in_scattering::Beam,
    oracle::{
        self, DVec3,
        climb::{self, Search, Worst},
    },
    sweep,
    views::{distances, exact, exactly},
};

/// Works on numbered items on all processors, with random numbers that depend on the item alone.
fn in_parallel(items: u64, work: impl Fn(&mut Rng, u64) + Sync) {
    let next = AtomicU64::new(0);
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                let numbers = std::iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed));
                numbers
                    .take_while(|&number| number < items)
                    .for_each(|number| work(&mut Rng::with_seed(number), number));
            });
        }
    });
}

fn haze(rng: &mut Rng) -> Haze {
    let haze = Haze::new(0.5).expect("a sound density");
    haze.with_source_radius(1e-3 * 100.0_f32.powf(rng.f32())).expect("a sound radius")
}

/// The largest error over many rays of the soft edge, relative to what is seen there or to what a
/// line sees that crosses the beam at the angle of the ray and as near to the light, whichever is
/// more; and over what passing close to the light magnifies. There is none at the rim of the
/// light's body, where the light jumps.
fn largest<A: Attenuation + Sync>(half: f32, model: A, attenuation: oracle::Attenuation, range: f64) -> f64 {
    let largest = Mutex::new(0.0_f64);
    in_parallel(if is_full() { 5_250 } else { 53 }, |rng, _| {
        let spot = sweep::spot(rng, Cone::from_outer(Soft, HalfAngle::degrees(half)).expect("a sound angle"));
        let haze = haze(rng);
        let beam = spot.with_attenuation(model).compile::<f32>().expect("held").in_haze(&haze);
        let cone = oracle::Cone::new(oracle::soft, spot.cone().outer_versine().into());
        let oracle = Beam {
            spot: oracle::SpotLight { attenuation, ..sweep::stored::<f32, _, _>(&spot, cone) },
            range,
            density: haze.density().into(),
            source_radius: haze.source_radius().into(),
        };
        let angle = f64::from(half).to_radians();
        let frame = Frame::new(rng, spot.position(), spot.axis(), angle);
        let rays: ViewRays<16> = frame.rays(rng);
        let across = oracle.across();
        let errors = (0..16).map(|i| {
            let view = rays.at(i);
            // The oracle divides a ray in panels, which have an end.
            let view = ViewRay { length: view.length.min(1e4), ..view };
            let ray = exactly(&view);
            let way = ray.eye - oracle.spot.position;
            let distance = way.length();
            let (nearest, height) = distances(&oracle, &ray);
            let body = oracle.source_radius;
            if (height - body).abs() < 0.1 * body + 1e-6 * distance {
                return 0.0;
            }
            let along = ray.direction.dot(oracle.spot.axis);
            let sine = (1.0 - along * along).max(0.0).sqrt().max(angle.sin());
            let seen = across * nearest * oracle.spot.attenuation.at(nearest) / sine;
            let truth = oracle.in_scattering(&ray);
            let error = (f64::from(beam.in_scattering(&view)) - truth).abs();
            // Where there is no light there is no error either.
            if error == 0.0 {
                return 0.0;
            }
            oracle::counted(error / truth.max(seen) / (1.0 + distance / height.max(body)))
        });
        let error = errors.fold(0.0, f64::max);
        let mut largest = largest.lock().expect("no other processor has failed");
        *largest = largest.max(error);
    });
    largest.into_inner().expect("no processor has failed")
}

#[test]
fn rays_near_critical_directions_keep_their_rows() {
    let window = FilamentRange::new(InverseSquare, Some(6.0)).expect("a sound range");
    let square = HALF_ANGLES
        .map(|half| largest(half, InverseSquare, oracle::Attenuation::InverseSquare, f64::INFINITY));
    let windowed =
        HALF_ANGLES.map(|half| largest(half, window, oracle::Attenuation::FilamentRange(6.0), 6.0));
    for (name, measured) in [("inverse square", square), ("Filament range", windowed)] {
        println!("{name} {}", bounds::shown(&measured));
        if is_full() {
            bounds::assert_kept(&bounds::broken("haze critical", name, "f32", &measured));
        }
        // The quick run sees the first of these rays: too few to tell that a bound is loose.
        let bounds = bounds::of("haze critical", name, "f32").expect("a row");
        assert!(
            measured.iter().zip(&bounds).all(|(error, bound)| error <= bound),
            "{measured:?}, expected {bounds:?}"
        );
    }
}

/// By how much a plane through the light separates a beam from a ray, relative to the distances of the ray's ends: the
/// measure of `can_meet` in f64, with the normals that it tries.
fn separation(
    beam: &BeamScattering<AnyFalloff, AnyAttenuation>,
    light: DVec3,
    axis: DVec3,
    view: &ViewRay,
) -> f64 {
    let (eye, direction) = (exact(view.eye) - light, exact(view.direction));
    let length = f64::from(view.length).min(1e9);
    let versine = f64::from(beam.outer_versine());
    let (sine, cosine) = ((versine * (2.0 - versine)).max(0.0).sqrt(), 1.0 - versine);
    let outward = |side: DVec3| cosine * side.reject_from(axis).normalize_or_zero() - sine * axis;
    let [first, last] = [eye, eye + length * direction].map(|v| v.reject_from(axis).normalize_or_zero());
    let back = eye.normalize();
    let beside_ray = |side: DVec3| -side.reject_from(direction).normalize_or_zero();
    let normals =
        [back, outward(first), outward(first + last), outward(last), beside_ray(axis), beside_ray(-back)];
    let separation = |normal: DVec3| {
        let (near, along) = (normal.dot(eye), normal.dot(axis));
        let beside = along * cosine + normal.reject_from(axis).length() * sine;
        let slack = if along > cosine { 1.0 } else { beside.max(0.0) };
        let far = near + length * normal.dot(direction);
        (near / eye.length()).min(far / (eye.length() + length)) - slack
    };
    normals.into_iter().map(separation).fold(-1.0, f64::max)
}

/// No beam of 0.1 degrees and more is lit along a ray that it cannot meet. By the roundings of the evaluation, planes
/// separate lit rays from their beams by less than a sixth of the margin of `can_meet`, 2e-5.
#[test]
fn lit_rays_are_met_by_far() {
    let worst = Mutex::new(0.0_f64);
    in_parallel(if is_full() { 10_000 } else { 60 }, |rng, number| {
        let falloff = AnyFalloff::anywhere(number as usize, || rng.f32());
        let attenuation = AnyAttenuation::anywhere(rng.usize(..), || rng.f32());
        let half = 0.1 * 900.0_f32.powf(rng.f32() * rng.f32());
        let (Ok(falloff), Ok(attenuation)) = (falloff, attenuation) else { return };
        let spot = Cone::from_outer(falloff, HalfAngle::degrees(half)).map(|cone| sweep::spot(rng, cone));
        let Ok(lit) = spot.and_then(|spot| spot.with_attenuation(attenuation).compile::<f32>()) else {
            return;
        };
        let beam = lit.in_haze(&haze(rng));
        let half = oracle::half_degrees(beam.outer_versine().into());
        if half < 0.1 {
            return;
        }
        let frame = Frame::new(rng, lit.position(), lit.axis(), half.to_radians());
        let (light, axis) = (exact(lit.position()), exact(lit.axis()).normalize());
        let error = |view: ViewRay| {
            if beam.in_scattering(&view) == 0.0 {
                return 0.0;
            }
            let ViewRay { eye, direction, length } = view;
            let meets = beam.can_meet(&RayBundle { eye, direction, versine: 0.0, length });
            if meets { 1.0 + separation(&beam, light, axis, &view) } else { f64::INFINITY }
        };
        let somewhere = |rng: &mut Rng| {
            let (eye, is_critical) = (frame.eye(rng), rng.u8(..4) > 0);
            frame.ray(rng, eye, is_critical)
        };
        let moved = |rng: &mut Rng, view: ViewRay| {
            let (size, step) = (climb::size(rng), climb::ulp_step(rng));
            match rng.u8(..5) {
                0 => ViewRay { length: view.length * (1.0 + size), ..view },
                1 | 2 => ViewRay { eye: climb::one_of(rng, view.eye, step), ..view },
                _ => {
                    let bent = climb::one_of(rng, view.direction, |c| c + size);
                    ViewRay { direction: sweep::single(exact(bent).normalize()), ..view }
                }
            }
        };
        let search = Search { starts: 500, climbs: 6, steps: 1_500, seed: number };
        let Some(Worst { input, error }) = search.worst(somewhere, moved, error) else { return };
        assert!(
            error.is_finite(),
            "{falloff:?} {attenuation:?} {half} degrees {lit:?}: {input:?} is not met"
        );
        let mut worst = worst.lock().expect("no other processor has failed");
        *worst = worst.max(error - 1.0);
    });
    let worst = worst.into_inner().expect("no processor has failed");
    println!("lit rays are separated by up to {worst:.2e}");
    assert!((5e-8..3.2e-6).contains(&worst), "{worst:e}");
}
