//! Air light searched where the arc that a light sees of a view ray is nearly degenerate: half of
//! all rays are within 0.01 rad of a critical direction.
//!
//! `LUMINAIRE_FULL=1 cargo test --test slow haze_search:: -- --nocapture --test-threads 1` compares
//! 10^6 rays with the oracle.

use fastrand::Rng;
use luminaire::{
    Cone, HalfAngle,
    attenuation::{Attenuation, FilamentRange, InverseSquare},
    falloff::Soft,
    haze::{Haze, ViewRay, ViewRays},
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
    oracle::{self},
    sweep,
    views::{distances, exactly},
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
