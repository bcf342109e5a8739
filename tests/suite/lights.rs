//! Attenuations, highlights and all kinds of light: defined results for all inputs, exact
//! early-outs and monotonicity.

use fastrand::Rng;
use luminaire::{
    Cone, DirectionalLight, Fx16, Fx32, Material, PointLight, Rgb, SpotLight, Vec3,
    attenuation::{
        AnyAttenuation, Attenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation,
        Polynomial, SmoothRange,
    },
    display::{clip, compress_keep_hue},
    falloff::Soft,
    light::{CompiledPointLight, CompiledSpotLight, LightModel, SurfacePoint},
    number::Gain,
    specular::{BlinnPhong, DifferenceForm, DualConeLobe, NoSpecular, Phong, SpecularLobe},
};
use support::assert_that;
use support::{arbitrary::vector, format::Format, sweep};

fn any_surface<S: Format>(rng: &mut Rng) -> SurfacePoint<S> {
    SurfacePoint {
        point: vector(rng, S::length_from_bits),
        normal: vector(rng, S::scalar_from_bits),
        view: vector(rng, S::unit_from_bits),
    }
}

/// A sound result, bit-identical with and without early-outs.
fn assert_answer<S: Format, H: SpecularLobe>(
    material: Material<H>,
    light: &impl LightModel<S>,
    surface: &SurfacePoint<S>,
) {
    let material = material.compile::<S>();
    let (skipped, whole) = (material.reflect(surface, light), material.reflect_unskipped(surface, light));
    assert_eq!(skipped, whole, "{material:?} {light:?} {surface:?}");
    for channel in [whole.red, whole.green, whole.blue] {
        let value = S::exact_light(channel);
        assert_that!(value >= 0.0 && value.is_finite(), material, light, surface, value);
    }
    for fitted in [clip::<S>(whole), compress_keep_hue::<S>(whole)] {
        for channel in [fitted.red, fitted.green, fitted.blue] {
            assert_that!((0.0..=1.0).contains(&channel.exact()), whole, channel);
        }
    }
}

/// Asserts a sound answer on a matte surface alone, because a lobe sees nothing of a light's
/// attenuation.
fn assert_matte<S: Format, L: LightModel<S>>(light: &L, surface: &SurfacePoint<S>) {
    let matte = Material::new(Rgb::new(0.5, 0.25, 1.0)).expect("sound");
    assert_answer::<S, NoSpecular>(matte, light, surface);
}

fn assert_all_highlights<S: Format, L: LightModel<S>>(light: &L, surface: &SurfacePoint<S>) {
    assert_matte(light, surface);
    let matte = Material::new(Rgb::new(0.5, 0.25, 1.0)).expect("sound");
    let gloss = Rgb::new(1.0, 0.5, 0.75);
    assert_answer(matte.with_highlight(Phong, gloss, 7).expect("sound"), light, surface);
    assert_answer(matte.with_highlight(BlinnPhong, gloss, 1024).expect("sound"), light, surface);
    assert_answer(matte.with_highlight(DualConeLobe, gloss, 1).expect("sound"), light, surface);
    assert_answer(
        matte.with_highlight(DifferenceForm::<_, 3>(Phong), gloss, 90).expect("sound"),
        light,
        surface,
    );
    assert_answer(
        matte.with_highlight(DifferenceForm::<_, 2>(BlinnPhong), gloss, 4).expect("sound"),
        light,
        surface,
    );
}

/// A check of the light of a spotlight or a point light at a surface.
type Check<L, S> = fn(&L, &SurfacePoint<S>);

fn assert_model<S: Format, A: Attenuation>(
    rng: &mut Rng,
    of_spot: Check<CompiledSpotLight<S, Soft, A>, S>,
    of_point: Check<CompiledPointLight<S, A>, S>,
    model: impl Fn(f32) -> A,
) {
    for _ in 0..60 * sweep::effort() {
        let range = 1.0 + 30.0 * rng.f32();
        let cone = Cone::from_outer(Soft, sweep::half(5.0 + 80.0 * rng.f32())).expect("a sound cone");
        let spot = sweep::spot(rng, cone).with_intensity(1e9 * rng.f32()).expect("sound");
        let spot = spot.with_attenuation(model(range));
        let point = PointLight::new(spot.position()).and_then(|point| point.with_intensity(1e9 * rng.f32()));
        let point = point.expect("sound").with_attenuation(model(range));
        let position = S::exact_point(spot.position().map(S::length));
        let (spot, point) = (spot.compile::<S>().expect("held"), point.compile::<S>().expect("held"));
        for _ in 0..50 {
            let surface = any_surface::<S>(rng);
            of_spot(&spot, &surface);
            of_point(&point, &surface);
        }
        // Points near the light, in its light, and at the edges of the cone and of the range.
        for _ in 0..50 {
            let way = sweep::direction(rng);
            let stretch = [0.5, 0.999, 1.0, 1.000_01, 1.2][rng.usize(..5)];
            let site = sweep::on_grid(position + f64::from(range) * stretch * way);
            let surface = SurfacePoint::<S>::seen_from(
                sweep::single(sweep::direction(rng)).map(S::length),
                sweep::single(site).map(S::length),
                sweep::single(sweep::direction(rng)).map(S::from_f32),
            );
            of_spot(&spot, &surface);
            of_point(&point, &surface);
        }
    }
}

fn assert_total<S: Format>() {
    let rng = &mut Rng::with_seed(0x11_6875);
    assert_model::<S, InverseSquare>(rng, assert_all_highlights, assert_all_highlights, |_| InverseSquare);
    let models: [fn(f32) -> AnyAttenuation; 8] = [
        |_| NoAttenuation.into(),
        |range| Polynomial::new(0.0, 1.0, range).expect("sound").into(),
        |_| Polynomial::new(0.0, 0.0, 0.0).expect("sound").into(),
        |range| SmoothRange::new(range).expect("sound").into(),
        |range| GltfRange::new(InverseSquare, Some(range)).expect("sound").into(),
        |_| GltfRange::new(InverseSquare, None).expect("sound").into(),
        |range| FilamentRange::new(InverseSquare, Some(range)).expect("sound").into(),
        |range| CutAt::new(NoAttenuation, Some(range)).expect("sound").into(),
    ];
    for model in models {
        assert_model::<S, AnyAttenuation>(rng, assert_matte, assert_matte, model);
    }
    for _ in 0..2_000 {
        let direction = sweep::single(sweep::direction(rng));
        let sun = DirectionalLight::new(direction).and_then(|sun| sun.with_intensity(1e9 * rng.f32()));
        assert_all_highlights(&sun.expect("sound").compile::<S>(), &any_surface(rng));
    }
}

#[test]
fn every_bit_pattern_has_an_answer_in_f32() {
    assert_total::<f32>();
}

#[test]
fn every_bit_pattern_has_an_answer_in_fx32() {
    assert_total::<Fx32>();
}

#[test]
fn every_bit_pattern_has_an_answer_in_fx16() {
    assert_total::<Fx16>();
}

/// Along a coordinate axis an attenuation starts at `starts`, never rises by more than `steps`
/// steps of the format, and ends at exactly zero.
fn assert_falls<S: Format, A: Attenuation>(model: A, range: f32, starts: f64, steps: f64) {
    let light = PointLight::new(Vec3::default())
        .expect("sound")
        .with_attenuation(model)
        .compile::<S>()
        .expect("held");
    let toward = Vec3::new(S::from_f32(-1.0), S::ZERO, S::ZERO);
    let at = |quanta: i32| {
        let place = Vec3::new(quanta as f32 / 65_536.0, 0.0, 0.0).map(S::length);
        S::exact_light(light.irradiance(place, toward))
    };
    let last = (range * 65_536.0) as i32;
    assert!((at(1) - starts).abs() <= 4.0 * f64::from(S::STEP), "starts at {}", at(1));
    let mut previous = f64::INFINITY;
    for quanta in (1..last + last / 8).step_by(7) {
        let light = at(quanta);
        assert_that!(light <= previous + steps * f64::from(S::STEP), model, S::NAME, quanta);
        if quanta >= last {
            assert_eq!(light, 0.0, "{model:?} {}: {quanta}", S::NAME);
        }
        previous = light;
    }
}

fn assert_monotone<S: Format>(steps: f64) {
    let range = 3.0;
    assert_falls::<S, _>(SmoothRange::new(range).expect("sound"), range, 1.0, steps);
    let cut = |coefficients: [f32; 3]| {
        let [constant, linear, quadratic] = coefficients;
        CutAt::new(Polynomial::new(constant, linear, quadratic).expect("sound"), Some(range)).expect("sound")
    };
    assert_falls::<S, _>(cut([0.5, 0.3, 0.7]), range, 1.0, steps);
    assert_falls::<S, _>(cut([1.0, 0.0, 0.0]), range, 1.0, steps);
}

#[test]
fn distance_models_never_rise() {
    assert_monotone::<f32>(2.0);
    assert_monotone::<Fx32>(8.0);
    // The distance has 15 bits, so its relative rounding changes by a factor of two at a power of
    // two.
    assert_monotone::<Fx16>(2.0);
}

/// The arithmetic of gains: a factor of one changes nothing, a reciprocal is capped, and small
/// gains are not lost.
fn assert_gains<S: Format>() {
    let mut rng = Rng::with_seed(9);
    let one = S::gain(1.0);
    for _ in 0..20_000 {
        let exponent = rng.i32(-40..40);
        let value = (1.0 + rng.f32()) * 2.0_f32.powi(exponent);
        let (a, b) = (S::gain(value), S::gain(value * 0.37));
        assert_eq!(S::ONE.expose(a.by(one)), S::ONE.expose(a));
        assert_eq!(a.plus(S::gain(0.0)), a);
        let as_light = |gain| S::exact_light(S::ONE.expose(gain));
        if (-8..8).contains(&exponent) {
            let value = f64::from(value);
            let near = |found: f64, exact: f64| (found - exact).abs() <= 7e-5 * exact + f64::from(S::STEP);
            assert_that!(near(as_light(a.plus(b)), value * 1.37), value);
            assert_that!(near(as_light(a.by(b)), value * value * 0.37), value);
            assert_that!(near(as_light(a.inverse_capped()), (1.0 / value).min(1.0)), value);
            assert_that!(near(a.fraction().exact(), value.min(1.0)), value);
        }
        let light = value.clamp(0.001, 1.0);
        let light = S::from_f32(light).expose(S::gain(100.0));
        assert_eq!(S::amplify(light, one), light);
    }
    assert_eq!(S::gain(0.0).inverse_capped(), one);
    assert_eq!(one.inverse_capped(), one);
}

#[test]
fn gains_keep_their_leading_bits() {
    assert_gains::<f32>();
    assert_gains::<Fx32>();
    assert_gains::<Fx16>();
}

/// A spotlight from two points equals the one from position, axis and range.
#[test]
fn one_vector_gives_direction_and_range() {
    let mut rng = Rng::with_seed(12);
    let cone = Cone::from_field(Soft, sweep::half(20.0)).expect("a sound cone");
    for _ in 0..1_000 {
        let (position, way) = (Vec3::new(1.0, 2.0, 3.0), sweep::direction(&mut rng));
        let end = sweep::single(5.0 * way).zip(position, |w, p| w + p);
        let spot = SpotLight::between(position, end, cone).expect("sound");
        let off = f32::exact_direction(spot.axis()) - way;
        assert!(off.length() < 1e-6);
        assert!((spot.attenuation().range() - 5.0).abs() < 1e-5);
    }
}

/// However near the point is to the light, and however small the numbers become, the light is at
/// most the intensity.
#[test]
fn no_light_is_made_next_to_its_source() {
    let source = PointLight::new(Vec3::default()).expect("sound").with_attenuation(NoAttenuation);
    let source = source.compile::<f32>().expect("held");
    for exponent in 0..=149 {
        let point = Vec3::new(0.0, 0.5_f32.powi(exponent), 0.0);
        let light = source.irradiance_unskipped(point, Vec3::new(0.0, -1.0, 0.0));
        assert_that!(light <= 1.0, light, exponent);
        // From 2^-64 on the squared distance is no normal number, and the point counts as on the
        // light.
        assert_eq!(light > 0.0, exponent < 64, "{light} at 2^-{exponent}");
        assert_eq!(light, source.irradiance(point, Vec3::new(0.0, -1.0, 0.0)));
    }
}

/// Products of gains may underflow to zero or saturate.
#[test]
fn gains_never_overflow() {
    fn powers<S: Format>() {
        for gain in [0.3, 3.0, 1e-38, 3e38] {
            let power = (0..64).fold(S::gain(gain), |power, _| power.by(power));
            let sum = power.plus(S::gain(1.0)).plus(power);
            let light = S::exact_light(S::ONE.expose(sum));
            assert_that!(light >= 0.0 && light.is_finite(), gain, light);
        }
    }
    powers::<f32>();
    powers::<Fx32>();
    powers::<Fx16>();
}
