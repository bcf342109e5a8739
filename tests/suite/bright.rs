//! Points next to bright lights in `Fx16`, which evaluates them finely: the slow tests measure every
//! light and intensity.

use fastrand::Rng;
use luminaire::{
    Angle, Cone, Fx16, Fx32, PointLight, Scalar, SpotLight,
    attenuation::{Attenuation, CutAt, FilamentRange, GltfRange, InverseSquare, Polynomial, SmoothRange},
    falloff::Linear,
    number::Arithmetic,
};
use support::{
    format::Format,
    oracle::{self, DVec3},
    sweep,
};

const RANGE: f32 = 5.0;

/// A point up to 5 from a position, more often near the axis' edge, and a normal from facing to
/// grazing.
fn site(rng: &mut Rng, position: DVec3, axis: DVec3, half: f64) -> (DVec3, DVec3) {
    let off_axis = half * (1.0 - rng.f64().powi(3));
    let way = sweep::direction_off(rng, axis, off_axis);
    let distance = 0.1 * 50.0_f64.powf(rng.f64());
    let incidence = std::f64::consts::FRAC_PI_2 * (1.0 - rng.f64().powi(rng.i32(1..12)));
    (position + distance * way, sweep::direction_off(rng, -way, incidence))
}

/// The errors in codes of what a display shows, beyond those that the direction makes.
fn largest_error<A: Attenuation>(attenuation: A) -> f64 {
    const HALF: f64 = 30.0;
    let (mut worst, mut rng) = (0.0_f64, Rng::with_seed(77));
    let exact_cone = oracle::Cone::new(oracle::linear, oracle::versine(HALF));
    let slope = f64::from(Fx16::DIRECTION_ERROR) * (2.0 / (2.0 * exact_cone.outer).sqrt() + 1.0);
    for intensity in [30.0_f32, 300.0, 3_000.0] {
        let cone = Cone::from_outer(Linear, Angle::degrees(2.0 * HALF as f32)).expect("a sound cone");
        let spot = sweep::spot(&mut rng, cone).with_attenuation(attenuation);
        let compiled = spot.with_intensity(intensity).and_then(|spot| spot.compile::<Fx16>()).expect("sound");
        let position = Fx16::exact_point(spot.position().map(Fx16::length));
        let axis = Fx16::exact_direction(spot.axis_in::<Fx16>()).normalize();
        for _ in 0..6_000 {
            let (point, normal) = site(&mut rng, position, axis, HALF.to_radians());
            let point = sweep::single(sweep::on_grid(point)).map(Fx16::length);
            let normal = sweep::single(normal).map(Fx16::from_f32);
            let way = Fx16::exact_point(point) - position;
            let cosine = -way.normalize().dot(Fx16::exact_normal(normal));
            if (way.length() / f64::from(RANGE) - 1.0).abs() < 1e-4 {
                continue;
            }
            let gain = f64::from(intensity) * attenuation.exact(way.length());
            let share = exact_cone.falloff(oracle::versine_between(way, axis)) * cosine.max(0.0);
            let found = Fx16::exact_light(compiled.irradiance(point, normal));
            let error = (found.min(1.0) - (gain * share).min(1.0)).abs() - gain * slope;
            worst = worst.max(255.0 * error);
        }
    }
    worst
}

#[test]
fn a_bright_spotlight_is_within_half_a_code() {
    let sound = "a sound range";
    let errors = [
        largest_error(InverseSquare),
        largest_error(Polynomial::new(1.0, 0.25, 0.5).expect("sound")),
        largest_error(SmoothRange::new(RANGE).expect(sound)),
        largest_error(GltfRange::new(InverseSquare, Some(RANGE)).expect(sound)),
        largest_error(FilamentRange::new(InverseSquare, Some(RANGE)).expect(sound)),
        largest_error(CutAt::new(InverseSquare, Some(RANGE)).expect(sound)),
    ];
    println!("{errors:.2?} codes");
    assert!(errors.iter().all(|error| *error <= 0.5), "{errors:.2?} codes");
}

/// The end of a window dims light whose share without the window is exact enough. The light shown
/// must be that of the windowed share.
#[test]
fn a_bright_light_is_not_white_where_its_window_dims_it() {
    let cone = Cone::from_outer(Linear, Angle::degrees(9.3)).expect("a sound cone");
    let spot = SpotLight::new([0.0; 3], [0.0, 0.0, 1.0], cone).expect("a sound light");
    let spot = spot.with_intensity(1_000.0).expect("a sound intensity");
    assert_windowed(spot.with_attenuation(GltfRange::new(InverseSquare, Some(0.51)).expect("sound")));
    assert_windowed(spot.with_attenuation(FilamentRange::new(InverseSquare, Some(0.51)).expect("sound")));

    fn assert_windowed<A: Attenuation>(spot: SpotLight<Linear, A>) {
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

/// The cosine alone, at normals of every direction, most of them grazing.
#[test]
fn a_bright_point_light_is_within_half_a_code() {
    let (mut worst, mut rng) = (0.0_f64, Rng::with_seed(78));
    for intensity in [30.0_f32, 3_000.0] {
        let light = PointLight::new([1.5, -0.25, 2.0]).and_then(|light| light.with_intensity(intensity));
        let light = light.and_then(|light| light.compile::<Fx16>()).expect("a sound light");
        let position = DVec3::new(1.5, -0.25, 2.0);
        for _ in 0..40_000 {
            let axis = sweep::direction(&mut rng);
            let (point, normal) = site(&mut rng, position, axis, 3.0);
            let point = sweep::single(sweep::on_grid(point)).map(Fx16::length);
            let normal = sweep::single(normal).map(Fx16::from_f32);
            let way = Fx16::exact_point(point) - position;
            let gain = f64::from(intensity) / way.length_squared();
            let exact = gain * -way.normalize().dot(Fx16::exact_normal(normal)).min(0.0);
            let found = Fx16::exact_light(light.irradiance(point, normal));
            let error = (found.min(1.0) - exact.min(1.0)).abs() - gain * f64::from(Fx16::DIRECTION_ERROR);
            worst = worst.max(255.0 * error);
        }
    }
    println!("{worst:.2} codes");
    assert!(worst <= 0.5, "{worst:.2} codes");
}

/// Normals that graze the light: the offset to the point is truncated, which must not turn a surface
/// away that the light just reaches.
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
        let across = sweep::direction_off(&mut rng, exact_normal, std::f64::consts::FRAC_PI_2);
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
    println!("{worst:.2} codes");
    assert!(worst <= 0.5, "{worst:.2} codes");
}
