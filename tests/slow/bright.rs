//! Bright lights: what a display shows of a spotlight whose intensity is far over full scale, in
//! linear codes, clipped at one.
//!
//! An error of the share of the intensity that arrives is multiplied by the gain, which is the
//! intensity over the squared distance where the light falls so. The error of the direction is: by
//! the slope of the edge. All other roundings together must add no more than half a code to that.
//!
//! `cargo test --test slow bright:: -- --nocapture --test-threads 1` prints the rows.

use fastrand::Rng;
use luminaire::{
    Cone, Fx16, Fx32, PointLight,
    attenuation::{
        Attenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
        Windowed,
    },
    falloff::{AnyFalloff, Hard, Linear, Smooth, Soft},
};
use support::{
    format::Format,
    oracle::{self, DVec3},
    sweep,
};

const INTENSITIES: [f32; 7] = [1.0, 10.0, 100.0, 300.0, 1_000.0, 3_000.0, 10_000.0];
const HALF_ANGLES: [f32; 6] = [3.0, 7.5, 15.0, 30.0, 60.0, 89.0];
const RANGES: [f32; 3] = [2.0, 5.0, 40.0];

/// The largest errors for one intensity, in codes.
#[derive(Clone, Copy, Default, Debug)]
struct Errors {
    /// In all.
    total: f64,
    /// Over what the error of the direction makes.
    rounding: f64,
}

impl Errors {
    fn add(&mut self, found: f64, exact: f64, direction: f64) {
        assert!(!found.is_nan());
        let error = 255.0 * (found.min(1.0) - exact.min(1.0)).abs();
        self.total = self.total.max(error);
        self.rounding = self.rounding.max(error - 255.0 * direction);
    }
}

/// A place and a surface normal: near and far from a light of this intensity, where it is not past
/// full scale for certain.
struct Site {
    point: DVec3,
    normal: DVec3,
}

fn site(rng: &mut Rng, position: DVec3, axis: DVec3, half: f64, reach: f64) -> Site {
    // More often at the edge, where little of a bright light is left.
    let off_axis = half * (1.0 - rng.f64().powi(rng.i32(1..6)));
    let way = sweep::direction_off(rng, axis, off_axis);
    let distance = (reach * 10.0_f64.powf(1.2 * rng.f64() - 1.0)).max(0.02);
    // From facing to grazing.
    let incidence = std::f64::consts::FRAC_PI_2 * (1.0 - rng.f64().powi(rng.i32(1..6)));
    Site { point: position + distance * way, normal: sweep::direction_off(rng, -way, incidence) }
}

/// The errors of spotlights under a distance model, whose gain at a distance is `gain` for an
/// intensity of 1.
fn spots<S: Format, A: Attenuation>(
    rng: &mut Rng,
    attenuation: A,
    gain: impl Fn(f64) -> f64,
    reach: impl Fn(f64) -> f64,
    jump: Option<f64>,
    errors: &mut [Errors; INTENSITIES.len()],
) {
    let falloffs: [(AnyFalloff, oracle::Falloff); 4] = [
        (Soft.into(), oracle::soft),
        (Hard.into(), oracle::hard),
        (Linear.into(), oracle::linear),
        (Smooth.into(), oracle::smooth),
    ];
    for (falloff, exact) in falloffs {
        for half_degrees in HALF_ANGLES {
            let cone = Cone::from_outer(falloff, sweep::half(half_degrees)).expect("a sound cone");
            let exact = oracle::Cone::new(exact, oracle::versine(half_degrees.into()));
            let chord = (2.0 * exact.outer).sqrt();
            let steepness = f64::from(luminaire::falloff::Falloff::steepness(falloff, 0.0));
            let slope = f64::from(S::DIRECTION_ERROR) * (steepness / chord + 1.0);
            for (intensity, errors) in INTENSITIES.into_iter().zip(&mut *errors) {
                let spot = sweep::spot(rng, cone).with_attenuation(attenuation);
                let spot = spot.with_intensity(intensity).expect("a sound intensity");
                let compiled = spot.compile::<S>().expect("held");
                let position = S::exact_point(spot.position().map(S::length));
                let axis = S::exact_direction(spot.axis_in::<S>()).normalize();
                for _ in 0..400 * sweep::effort() {
                    let half = f64::from(half_degrees).to_radians();
                    let site = site(rng, position, axis, half, reach(intensity.into()));
                    let point = sweep::single(sweep::on_grid(site.point)).map(S::length);
                    let normal = sweep::single(site.normal).map(S::from_f32);
                    let way = S::exact_point(point) - position;
                    let cosine = -way.normalize().dot(S::exact_normal(normal));
                    let distance = way.length();
                    // A cut is a jump, which is in its place within 1e-4 of the range.
                    if jump.is_some_and(|range| (distance / range - 1.0).abs() < 1e-4) {
                        continue;
                    }
                    let gain = f64::from(intensity) * gain(distance);
                    let share = exact.falloff(oracle::versine_between(way, axis)) * cosine.max(0.0);
                    let found = S::exact_light(compiled.irradiance(point, normal));
                    errors.add(found, gain * share, gain * slope);
                }
            }
        }
    }
}

/// The same of a point light: the cosine alone.
fn points<S: Format>(rng: &mut Rng, errors: &mut [Errors; INTENSITIES.len()]) {
    for (intensity, errors) in INTENSITIES.into_iter().zip(errors) {
        let position = DVec3::new(1.5, -0.25, 2.0);
        let point =
            PointLight::new(sweep::single(position)).and_then(|point| point.with_intensity(intensity));
        let compiled = point.and_then(|point| point.compile::<S>()).expect("sound");
        for _ in 0..20_000 * sweep::effort() {
            let axis = sweep::direction(rng);
            let site = site(rng, position, axis, 3.0, f64::from(intensity).sqrt());
            let point = sweep::single(sweep::on_grid(site.point)).map(S::length);
            let normal = sweep::single(site.normal).map(S::from_f32);
            let way = S::exact_point(point) - position;
            let gain = f64::from(intensity) / way.length_squared();
            let cosine = -way.normalize().dot(S::exact_normal(normal));
            let found = S::exact_light(compiled.irradiance(point, normal));
            errors.add(found, gain * cosine.max(0.0), gain * f64::from(S::DIRECTION_ERROR));
        }
    }
}

/// Every distance model: its name and the errors for each intensity.
fn rows<S: Format>() -> Vec<(String, [Errors; INTENSITIES.len()])> {
    let mut rows = Vec::new();
    let mut row = |name: String, fill: &mut dyn FnMut(&mut Rng, &mut [Errors; INTENSITIES.len()])| {
        let mut errors = [Errors::default(); INTENSITIES.len()];
        fill(&mut Rng::with_seed(1000), &mut errors);
        println!("{} {name}: {}", S::NAME, shown(&errors));
        rows.push((name, errors));
    };
    let far = |intensity: f64| intensity.sqrt();
    row("none".into(), &mut |rng, errors| spots::<S, _>(rng, NoAttenuation, |_| 1.0, |_| 10.0, None, errors));
    row("inverse square".into(), &mut |rng, errors| {
        spots::<S, _>(rng, InverseSquare, |d| 1.0 / (d * d), far, None, errors);
    });
    row("point light".into(), &mut |rng, errors| points::<S>(rng, errors));
    let polynomial = Polynomial::new(1.0, 0.25, 0.5).expect("sound");
    let exact_polynomial = oracle::Attenuation::Polynomial([1.0, 0.25, 0.5]);
    row("polynomial".into(), &mut |rng, errors| {
        spots::<S, _>(rng, polynomial, |d| exact_polynomial.at(d), far, None, errors);
    });
    for range in RANGES {
        let (some, r) = (Some(range), f64::from(range));
        let within = |intensity: f64| intensity.sqrt().min(r);
        let squared = |d: f64| (1.0 - (d / r).powi(4)).clamp(0.0, 1.0).powi(2);
        row(format!("smooth to {range}"), &mut |rng, errors| {
            let model = SmoothRange::new(range).expect("sound");
            spots::<S, _>(rng, model, |d| oracle::Attenuation::SmoothRange(r).at(d), |_| r, None, errors);
        });
        row(format!("window of {range}"), &mut |rng, errors| {
            let model = GltfRange::new(InverseSquare, some).expect("sound");
            spots::<S, _>(rng, model, |d| oracle::Attenuation::GltfRange(r).at(d), within, None, errors);
        });
        row(format!("Filament range of {range}"), &mut |rng, errors| {
            let model = FilamentRange::new(InverseSquare, some).expect("sound");
            spots::<S, _>(rng, model, |d| oracle::Attenuation::FilamentRange(r).at(d), within, None, errors);
        });
        row(format!("polynomial faded to {range}"), &mut |rng, errors| {
            let model = Windowed::new(polynomial, some).expect("sound");
            let exact = |d| exact_polynomial.at(d) * squared(d);
            spots::<S, _>(rng, model, exact, |_| r, None, errors);
        });
        row(format!("inverse square cut at {range}"), &mut |rng, errors| {
            let model = CutAt::new(InverseSquare, some).expect("sound");
            let exact = |d: f64| if d < r { 1.0 / (d * d) } else { 0.0 };
            spots::<S, _>(rng, model, exact, within, Some(r), errors);
        });
    }
    rows
}

fn shown(errors: &[Errors]) -> String {
    let shown = errors.iter().map(|Errors { total, rounding }| format!("{total:.2} ({rounding:.2})"));
    shown.collect::<Vec<_>>().join(", ")
}

/// The largest errors of a format over all rows, for each intensity.
fn largest<S: Format>() -> [Errors; INTENSITIES.len()] {
    rows::<S>().into_iter().fold([Errors::default(); INTENSITIES.len()], |largest, (_, errors)| {
        std::array::from_fn(|i| Errors {
            total: largest[i].total.max(errors[i].total),
            rounding: largest[i].rounding.max(errors[i].rounding),
        })
    })
}

/// All of the error is within half a code and within one up to the intensities that the format
/// states, and the next intensity is beyond that where there is a statement to break.
fn assert_up_to<S: Format>(half_a_code: f32, a_code: f32) -> [Errors; INTENSITIES.len()] {
    let largest = largest::<S>();
    println!("{}: {}", S::NAME, shown(&largest));
    for (codes, most) in [(0.5, half_a_code), (1.0, a_code)] {
        for (intensity, errors) in INTENSITIES.into_iter().zip(largest) {
            assert!(intensity > most || errors.total <= codes, "{} {intensity}: {errors:?}", S::NAME);
        }
    }
    largest
}

/// In 16 bits all other roundings add no more than half a code to what the direction makes, at any
/// of these intensities.
#[test]
fn fx16_adds_half_a_code_at_most() {
    for (intensity, errors) in INTENSITIES.into_iter().zip(assert_up_to::<Fx16>(300.0, 1_000.0)) {
        assert!((0.0..=0.5).contains(&errors.rounding), "{intensity}: {errors:?}");
        assert!(errors.total > 0.05, "{intensity}: {errors:?}");
    }
}

#[test]
fn fx32_keeps_its_intensities() {
    assert_up_to::<Fx32>(300.0, 1_000.0);
}

#[test]
fn f32_keeps_its_intensities() {
    assert_up_to::<f32>(10.0, 300.0);
}
