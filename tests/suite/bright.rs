//! Bright lights: what a display shows of lights whose intensity is far over full scale, in linear
//! codes, clipped at one.
//!
//! An error of the share of the intensity that arrives is multiplied by the gain, which is the
//! intensity over the squared distance where the light falls so. The error of the direction is: by
//! the slope of the edge. All other roundings together must add no more than half a code to that.
//!
//! `LUMINAIRE_FULL=1 cargo test --test suite bright:: -- --nocapture --test-threads 1` prints the
//! rows.

use fastrand::Rng;
use luminaire::{
    Angle, Cone, Fx16, Fx32, PointLight, SpotLight, Vec3,
    attenuation::{
        AnyAttenuation, Attenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation,
        Polynomial, SmoothRange, Windowed,
    },
    falloff::{AnyFalloff, Falloff, Hard, Linear, Smooth, Soft},
    number::Errors as _,
};
use std::f64::consts::FRAC_PI_2;
use support::{
    assert_in,
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

/// The errors for each of [`INTENSITIES`].
type Row = [Errors; INTENSITIES.len()];

impl Errors {
    fn add(&mut self, found: f64, exact: f64, direction: f64) {
        assert!(!found.is_nan(), "found NaN, expected {exact}");
        let error = 255.0 * (found.min(1.0) - exact.min(1.0)).abs();
        self.total = self.total.max(error);
        self.rounding = self.rounding.max(error - 255.0 * direction);
    }
}

/// A point and a surface normal as a format has them, and the exact way from a light to the point.
struct Site<S: Format> {
    point: Vec3<S::Length>,
    normal: Vec3<S>,
    way: DVec3,
    cosine: f64,
}

/// A place near or far from a light of this reach, more often at the edge of its cone, where little
/// of a bright light is left; and a normal from facing to grazing.
fn site<S: Format>(rng: &mut Rng, position: DVec3, axis: DVec3, half: f64, reach: f64) -> Site<S> {
    let off_axis = half * (1.0 - rng.f64().powi(rng.i32(1..6)));
    let way = sweep::direction_off(rng, axis, off_axis);
    let distance = (reach * 10.0_f64.powf(1.2 * rng.f64() - 1.0)).max(0.02);
    let incidence = FRAC_PI_2 * (1.0 - rng.f64().powi(rng.i32(1..12)));
    let normal = sweep::single(sweep::direction_off(rng, -way, incidence)).map(S::from_f32);
    let point = sweep::single(sweep::on_grid(position + distance * way)).map(S::length);
    let way = S::exact_point(point) - position;
    Site { point, normal, way, cosine: (-way.normalize().dot(S::exact_normal(normal))).max(0.0) }
}

/// Spotlights with an attenuation, of four falloffs and six angles. A cut is a jump, which is in
/// its place within 1e-4 of the range.
fn spots<S: Format>(rng: &mut Rng, attenuation: AnyAttenuation, reach: impl Fn(f64) -> f64) -> Row {
    let falloffs: [(AnyFalloff, oracle::Falloff); 4] = [
        (Soft.into(), oracle::soft),
        (Hard.into(), oracle::hard),
        (Linear.into(), oracle::linear),
        (Smooth.into(), oracle::smooth),
    ];
    let mut row = Row::default();
    for ((falloff, exact), half_degrees) in falloffs.iter().flat_map(|f| HALF_ANGLES.map(|half| (*f, half))) {
        let cone = Cone::from_outer(falloff, sweep::half(half_degrees)).expect("a sound cone");
        let exact = oracle::Cone::new(exact, oracle::versine(half_degrees.into()));
        let steepness = f64::from(falloff.steepness(0.0));
        let slope = f64::from(S::DIRECTION_ERROR) * (steepness / (2.0 * exact.outer).sqrt() + 1.0);
        for (intensity, errors) in INTENSITIES.into_iter().zip(&mut row) {
            let spot = sweep::spot(rng, cone).with_attenuation(attenuation);
            let spot = spot.with_intensity(intensity).expect("a sound intensity");
            let compiled = spot.compile::<S>().expect("held");
            let position = S::exact_point(spot.position().map(S::length));
            let axis = S::exact_direction(sweep::axis::<S, _, _>(&spot)).normalize();
            for _ in 0..100 * sweep::effort() {
                let half = f64::from(half_degrees).to_radians();
                let site = site::<S>(rng, position, axis, half, reach(intensity.into()));
                let distance = site.way.length();
                if attenuation.range().is_some_and(|range| (distance / f64::from(range) - 1.0).abs() < 1e-4) {
                    continue;
                }
                let gain = f64::from(intensity) * attenuation.exact(distance);
                let share = exact.falloff(oracle::versine_between(site.way, axis)) * site.cosine;
                let found = S::exact_light(compiled.irradiance(site.point, site.normal));
                errors.add(found, gain * share, gain * slope);
            }
        }
    }
    row
}

/// Point lights: the cosine alone.
fn points<S: Format>(rng: &mut Rng) -> Row {
    let position = DVec3::new(1.5, -0.25, 2.0);
    INTENSITIES.map(|intensity| {
        let light =
            PointLight::new(sweep::single(position)).and_then(|light| light.with_intensity(intensity));
        let compiled = light.and_then(|light| light.compile::<S>()).expect("sound");
        let mut errors = Errors::default();
        for _ in 0..20_000 * sweep::effort() {
            let axis = sweep::direction(rng);
            let site = site::<S>(rng, position, axis, 3.0, f64::from(intensity).sqrt());
            let gain = f64::from(intensity) / site.way.length_squared();
            let found = S::exact_light(compiled.irradiance(site.point, site.normal));
            errors.add(found, gain * site.cosine, gain * f64::from(S::DIRECTION_ERROR));
        }
        errors
    })
}

fn shown(row: &Row) -> String {
    row.map(|Errors { total, rounding }| format!("{total:.2} ({rounding:.2})")).join(", ")
}

/// The largest errors of a format over all attenuations, for each intensity.
fn largest<S: Format>() -> Row {
    let mut largest = Row::default();
    let mut note = |name: &dyn std::fmt::Debug, row: Row| {
        println!("{} {name:?}: {}", S::NAME, shown(&row));
        largest = std::array::from_fn(|i| Errors {
            total: largest[i].total.max(row[i].total),
            rounding: largest[i].rounding.max(row[i].rounding),
        });
    };
    let rng = &mut Rng::with_seed(1000);
    note(&"point light", points::<S>(rng));
    let sound = "a sound attenuation";
    let polynomial = Polynomial::new(1.0, 0.25, 0.5).expect(sound);
    note(&"none", spots::<S>(rng, NoAttenuation.into(), |_| 10.0));
    for falls in [InverseSquare.into(), polynomial.into()] {
        note(&falls, spots::<S>(rng, falls, f64::sqrt));
    }
    for range in RANGES {
        let (some, r) = (Some(range), f64::from(range));
        let whole = [
            SmoothRange::new(range).expect(sound).into(),
            Windowed::new(polynomial, some).expect(sound).into(),
        ];
        for fades in whole {
            note(&fades, spots::<S>(rng, fades, |_| r));
        }
        let bright = [
            GltfRange::new(InverseSquare, some).expect(sound).into(),
            FilamentRange::new(InverseSquare, some).expect(sound).into(),
            CutAt::new(InverseSquare, some).expect(sound).into(),
        ];
        for fades in bright {
            note(&fades, spots::<S>(rng, fades, |intensity| intensity.sqrt().min(r)));
        }
    }
    largest
}

/// All of the error is within half a code and within one up to the intensities that the format
/// states.
fn assert_up_to<S: Format>(half_a_code: f32, a_code: f32) -> Row {
    let largest = largest::<S>();
    println!("{}: {}", S::NAME, shown(&largest));
    for (codes, most) in [(0.5, half_a_code), (1.0, a_code)] {
        for (intensity, errors) in INTENSITIES.into_iter().zip(largest).filter(|(it, _)| *it <= most) {
            assert_in(&(S::NAME, intensity), errors.total, 0.0..=codes);
        }
    }
    largest
}

/// In 16 bits all other roundings add no more than half a code to what the direction makes, at any
/// of these intensities.
#[test]
fn fx16_adds_half_a_code_at_most() {
    for (intensity, errors) in INTENSITIES.into_iter().zip(assert_up_to::<Fx16>(300.0, 1_000.0)) {
        assert_in(&intensity, errors.rounding, 0.0..=0.5);
        assert_in(&intensity, errors.total, 0.05..);
    }
}

#[test]
fn fx32_keeps_its_intensities() {
    assert_up_to::<Fx32>(300.0, 1_000.0);
}

#[test]
fn f32_keeps_its_intensities() {
    assert_up_to::<f32>(10.0, 100.0);
}

/// The end of a window dims light whose share without the window is exact enough. The light shown
/// must be that of the windowed share.
#[test]
fn a_bright_light_is_not_white_where_its_window_dims_it() {
    let cone = Cone::from_outer(Linear, Angle::degrees(9.3)).expect("a sound cone");
    let spot = SpotLight::new([0.0; 3], [0.0, 0.0, 1.0], cone).expect("a sound light");
    let spot = spot.with_intensity(1_000.0).expect("a sound intensity");
    assert_windowed(spot.with_attenuation(GltfRange::new(InverseSquare, Some(0.51)).expect("sound").into()));
    assert_windowed(
        spot.with_attenuation(FilamentRange::new(InverseSquare, Some(0.51)).expect("sound").into()),
    );

    fn assert_windowed(spot: SpotLight<Linear, AnyAttenuation>) {
        let (found, exact) = (spot.compile::<Fx16>().expect("held"), spot.compile::<Fx32>().expect("held"));
        let mut rng = Rng::with_seed(80);
        for _ in 0..100_000 {
            let off = [0.08, 0.08, 0.02].map(|size| size * (rng.f32() - 0.5));
            let point = Fx16::point([off[0], off[1], 0.5 + off[2]]);
            let normal = [0.3 * rng.f32(), 0.1, -1.0].map(Fx16::from_f32);
            let shown = Fx16::exact_light(found.irradiance(point, normal.into())).min(1.0);
            let normal = normal.map(|c| Fx32::from_bits(i32::from(c.to_bits()) << 16));
            let expected = Fx32::exact_light(exact.irradiance(point, normal.into())).min(1.0);
            assert!(
                (shown - expected).abs() < 0.05,
                "{:?} at {point:?}: {shown}, expected {expected}",
                spot.attenuation()
            );
        }
    }
}

/// Normals that graze the light: the offset to the point is truncated, which must not turn a
/// surface away that the light just reaches.
#[test]
fn a_grazed_surface_is_not_dark() {
    let (mut worst, mut rng) = (0.0_f64, Rng::with_seed(79));
    let position = DVec3::new(1.5, -0.25, 2.0);
    let light = PointLight::new([1.5, -0.25, 2.0]).and_then(|light| light.with_intensity(1_000.0));
    let light = light.and_then(|light| light.compile::<Fx16>()).expect("a sound light");
    for _ in 0..40_000 {
        let normal = DVec3::new(0.5 + rng.f64(), 0.5 + rng.f64(), 0.5 + rng.f64()).normalize();
        let normal = sweep::single(if rng.bool() { normal } else { -normal }).map(Fx16::from_f32);
        let exact_normal = Fx16::exact_normal(normal);
        let across = sweep::direction_off(&mut rng, exact_normal, FRAC_PI_2);
        let way = across - 2e-4 * rng.f64() * exact_normal;
        let point = sweep::on_grid(position + (0.5 + 4.0 * rng.f64()) * way);
        let point = sweep::single(point).map(Fx16::length);
        let way = Fx16::exact_point(point) - position;
        let gain = 1_000.0 / way.length_squared();
        let exact = gain * -way.normalize().dot(exact_normal).min(0.0);
        let found = Fx16::exact_light(light.irradiance(point, normal));
        let error = (found.min(1.0) - exact.min(1.0)).abs() - gain * f64::from(Fx16::DIRECTION_ERROR);
        worst = worst.max(255.0 * error);
    }
    assert_in(&"codes", worst, 0.0..=0.5);
}
