//! The domain of validity: at each end of each documented range the promises hold, and outside the
//! range the documented result occurs.
//!
//! `cargo test --test suite domain:: -- --nocapture --test-threads 1` prints the errors at the
//! ends; `LUMINAIRE_FULL=1` looks 16 times as long.

use fastrand::Rng;
use luminaire::{
    Cone, Error, Fx16, Fx32, PointLight, SpotLight, Vec3,
    attenuation::NoAttenuation,
    error::{Expected, Parameter},
    falloff::{AnyFalloff, Falloff, IntegerPower, InvertedIntegerPower, InvertedRealPower, RealPower},
};
use support::{
    assert_that,
    falloffs::{Shape, four},
    format::Format,
    in_every_format,
    oracle::{self, DVec3},
    sweep,
};

/// The ranges of a format, as its documentation states them.
struct Domain {
    /// The largest coordinate of a light.
    light: f32,
    /// Coordinates of points are from minus this up to one quantum below this.
    point: f64,
    /// The shortest and the longest distance from a light to a point.
    distances: [f64; 2],
    /// The largest intensity whose light is within half a code, for half angles from 3 degrees and
    /// distances from half a unit.
    brightest: f32,
}

impl Domain {
    fn of<S: Format>() -> Self {
        const QUANTUM: f64 = 1.0 / 65_536.0;
        match S::NAME {
            "f32" => Self {
                light: f32::MAX,
                point: f32::MAX.into(),
                distances: [1.1e-19, 1.8e19],
                brightest: 10.0,
            },
            "fx32" => {
                Self { light: 32_639.0, point: 32_768.0, distances: [QUANTUM, 113_000.0], brightest: 300.0 }
            }
            _ => Self { light: 16_383.0, point: 32_768.0, distances: [QUANTUM, 85_000.0], brightest: 0.25 },
        }
    }
}

/// A light, and a point in or near its cone, both at positions that the format represents.
struct Scene {
    light: Vec3<f32>,
    axis: Vec3<f32>,
    point: Vec3<f32>,
}

impl Scene {
    /// A light and a point at given positions, and an axis at some angle to the direction between
    /// them.
    fn aimed<S: Format>(
        rng: &mut Rng,
        half_degrees: f32,
        light: Vec3<f32>,
        point: Vec3<f32>,
    ) -> Option<Self> {
        let [from, to] = [light, point].map(|place| S::exact_point(place.map(S::length)));
        let way = to - from;
        let most = way.abs().max_element();
        let off_axis = f64::from(half_degrees).to_radians() * rng.f64();
        let way = (most > 0.0).then(|| (way * (1.0 / most)).normalize())?;
        Some(Self { light, axis: sweep::single(sweep::direction_off(rng, way, off_axis)), point })
    }
}

/// The largest error of an intensity in these scenes, in linear codes.
fn worst<S: Format>(
    shape: &Shape<AnyFalloff>,
    half_degrees: f32,
    count: usize,
    mut scene: impl FnMut(&mut Rng) -> Option<Scene>,
) -> f64 {
    let (mut rng, cone) = (Rng::with_seed(7), shape.at(half_degrees));
    let truth = shape.exactly_at(half_degrees);
    let mut worst = 0.0_f64;
    for _ in 0..count * sweep::effort() {
        let Some(Scene { light, axis, point }) = scene(&mut rng) else { continue };
        let spot = SpotLight::new(light, axis, cone).expect("in the domain");
        let [from, to] = [light, point].map(|place| S::exact_point(place.map(S::length)));
        let way = to - from;
        // Squares of the shortest and the longest ways are within f64.
        let axis = S::exact_direction(sweep::axis::<S, _, _>(&spot)).normalize();
        let versine = oracle::versine_between(way, axis);
        let exact = truth.falloff(versine);
        let found = spot.compile::<S>().expect("in the domain").falloff_at(point.map(S::length)).exact();
        worst = worst.max(255.0 * (found - exact).abs());
    }
    worst
}

/// The error is within half a code, and large enough that the bound is not loose.
fn assert_held<S: Format>(what: &str, shape: &Shape<AnyFalloff>, half_degrees: f32, least: f64, codes: f64) {
    println!("{} {what}, {} at {half_degrees}: {codes:.3}", S::NAME, shape.name);
    // A cone with the fine evaluation in `Fx16` has only the error of the last rounding, half of
    // 2^-14.
    let least = if S::NAME == "fx16" { least.min(0.007) } else { least };
    let held = (least..=0.5).contains(&codes);
    assert!(held, "{} {what}, {} at {half_degrees}: {codes:.4} linear codes", S::NAME, shape.name);
}

fn assert_refused<T: core::fmt::Debug>(refused: Result<T, Error>, parameter: Parameter, accepted: Expected) {
    let error = refused.expect_err("outside of the domain");
    assert_eq!((error.parameter, error.accepted), (parameter, accepted), "{error}");
}

/// A coordinate at an end of the range, or anywhere in it.
fn coordinate(rng: &mut Rng, end: f64) -> f64 {
    match rng.u8(..3) {
        0 => end,
        1 => -end,
        _ => end * (2.0 * rng.f64() - 1.0),
    }
}

/// Lights and points at the ends of their coordinate ranges, near one another and far apart.
fn assert_positions<S: Format>(ends: [f64; 2]) {
    for shape in four() {
        // An offset of more than 32 bits loses one bit. There the narrowest cone of `Fx32` is a
        // quarter wider.
        let times = if S::NAME == "fx32" { 1.25 } else { 1.0 };
        for (half_degrees, least) in [(times * shape.narrowest::<S>(), 0.15 / f64::from(times)), (60.0, 0.0)]
        {
            let scene = |rng: &mut Rng| {
                let light = DVec3::from_array([0; 3].map(|_| coordinate(rng, ends[0])));
                let near = sweep::direction(rng).map(|c| ends[1] * 1e-3_f64.powf(rng.f64()) * c);
                let is_near = rng.bool();
                let far = |rng: &mut Rng| [0; 3].map(|_| coordinate(rng, ends[1])).into();
                let point = if is_near { light + near } else { far(rng) };
                let point = point.map(|c| c.clamp(-ends[1], ends[1]));
                Scene::aimed::<S>(rng, half_degrees, sweep::single(light), sweep::single(point))
            };
            let codes = worst::<S>(&shape, half_degrees, 4_000, scene);
            assert_held::<S>("positions", &shape, half_degrees, least, codes);
        }
    }
}

#[test]
fn positions_hold_at_their_ends() {
    assert_positions::<Fx16>([Domain::of::<Fx16>().light.into(), Domain::of::<Fx16>().point]);
    assert_positions::<Fx32>([Domain::of::<Fx32>().light.into(), Domain::of::<Fx32>().point]);
    // In f32 the distance has a limit; the coordinates are large enough to reach it.
    assert_positions::<f32>([1e18; 2]);
}

fn assert_farther_lights_refused<S: Format>() {
    let most = Domain::of::<S>().light;
    assert_eq!(S::FARTHEST, most);
    let at = |x: f32| {
        let cone = four()[0].at(30.0);
        let spot = SpotLight::new(Vec3::new(0.5, x, 0.0), Vec3::new(0.0, 1.0, 0.0), cone)?;
        let point = PointLight::new(spot.position())?;
        Ok((spot.compile::<S>()?, point.compile::<S>()?))
    };
    for sign in [1.0, -1.0] {
        assert!(at(sign * most).is_ok());
        assert_refused(at(sign * most.next_up()), Parameter::Position, Expected::Component("y", -most, most));
    }
}

#[test]
fn lights_beyond_the_domain_are_refused() {
    in_every_format!(assert_farther_lights_refused);
}

/// A point that fixed point cannot represent becomes the nearest representable one. A NaN
/// coordinate becomes 0 in fixed point, and the point is dark in f32.
#[test]
fn points_beyond_the_domain() {
    for beyond in [32_768.0, 1e9, f32::INFINITY] {
        assert_eq!(Fx32::exact_length(Fx32::length(beyond)), 32_768.0 - 0.5_f64.powi(16));
        assert_eq!(Fx16::exact_length(Fx16::length(-beyond)), -32_768.0);
    }
    assert_eq!(Fx32::exact_length(Fx32::length(f32::NAN)), 0.0);
    assert_eq!(Fx16::exact_length(Fx16::length(f32::NAN)), 0.0);
    for far in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(brightest_at::<f32>(Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.0, far, 0.0)), 0.0);
    }
}

/// The light of the brightest lights at a point that faces them: of the widest spotlight, with and
/// without early-outs and with and without attenuation, and of a point light.
fn brightest_at<S: Format>(light: Vec3<f32>, point: Vec3<f32>) -> f64 {
    let spot = SpotLight::new(light, Vec3::new(0.0, 1.0, 0.0), four()[0].at(90.0)).expect("sound");
    let spot = spot.with_intensity(1e9).expect("sound");
    let falling = spot.compile::<S>().expect("held");
    let constant = spot.with_attenuation(NoAttenuation).compile::<S>().expect("held");
    let source = PointLight::new(light).and_then(|source| source.with_intensity(1e9)).expect("sound");
    let source = source.compile::<S>().expect("held");
    let (point, normal) = (point.map(S::length), Vec3::new(S::ZERO, S::from_f32(-1.0), S::ZERO));
    let lights = [
        falling.irradiance(point, normal),
        falling.irradiance_unskipped(point, normal),
        constant.irradiance(point, normal),
        constant.irradiance_unskipped(point, normal),
        source.irradiance(point, normal),
    ];
    lights.into_iter().map(S::exact_light).fold(0.0, f64::max)
}

/// The shortest and the longest distances: a few quanta, and from corner to corner of the domain;
/// in f32 those whose square is a normal number.
fn assert_distances<S: Format>() {
    let Domain { light: farthest, point: end, distances: [shortest, longest], .. } = Domain::of::<S>();
    let is_float = S::NAME == "f32";
    for shape in four() {
        let half_degrees = shape.narrowest::<S>();
        let near = |rng: &mut Rng| {
            let way = if is_float {
                sweep::direction(rng).map(|c| c * shortest * (1.0 + rng.f64()))
            } else {
                DVec3::from_array([0; 3].map(|_| shortest * f64::from(rng.i8(-3..=3))))
            };
            let light = if is_float { DVec3::ZERO } else { sweep::on_grid([0; 3].map(|_| 8.0 * rng.f64())) };
            let point = light + way;
            Scene::aimed::<S>(rng, half_degrees, sweep::single(light), sweep::single(point))
        };
        let codes = worst::<S>(&shape, half_degrees, 4_000, near);
        assert_held::<S>("shortest ways", &shape, half_degrees, 0.1, codes);
        let mut seen = 0.0_f64;
        let far = |rng: &mut Rng| {
            let (light, point): (DVec3, DVec3) = if is_float {
                let way = sweep::direction(rng).map(|c| c * longest * (1.0 - 0.1 * rng.f64()));
                (sweep::direction(rng), way)
            } else {
                let corner = DVec3::from_array([0; 3].map(|_| if rng.bool() { 1.0 } else { -1.0 }));
                let inset = 1.0 - 0.001 * rng.f64();
                (corner * f64::from(farthest), -corner * end * inset)
            };
            seen = seen.max(point.distance(light));
            Scene::aimed::<S>(rng, half_degrees, sweep::single(light), sweep::single(point))
        };
        let codes = worst::<S>(&shape, half_degrees, 4_000, far);
        // In fixed point there is hardly any error, because an offset of that length uses all bits.
        assert_held::<S>("longest ways", &shape, half_degrees, if is_float { 0.1 } else { 1e-5 }, codes);
        assert_that!((0.99 * longest..1.01 * longest).contains(&seen), S::NAME, seen);
    }
}

#[test]
fn distances_hold_at_their_ends() {
    in_every_format!(assert_distances);
}

/// A point at the light is dark; in f32 so is a point whose squared distance is no normal number.
#[test]
fn distances_beyond_the_domain_are_dark() {
    let at = |y: f32| Vec3::new(0.0, y, 0.0);
    for place in [0.0, 1.5, -16_383.0] {
        assert_eq!(brightest_at::<f32>(at(place), at(place)), 0.0);
        assert_eq!(brightest_at::<Fx32>(at(place), at(place)), 0.0);
        assert_eq!(brightest_at::<Fx16>(at(place), at(place)), 0.0);
    }
    let [shortest, longest] = Domain::of::<f32>().distances.map(|distance| distance as f32);
    for inside in [shortest, longest] {
        assert_that!(brightest_at::<f32>(at(0.0), at(inside)) > 0.0, inside);
    }
    for outside in [0.98 * shortest, 1e-30, 1.03 * longest, 1e30, f32::MAX] {
        assert_eq!(brightest_at::<f32>(at(0.0), at(outside)), 0.0, "{outside}");
    }
}

/// However near the point is to the light, the light is at most the intensity. From 2^-64 on the
/// squared distance is no normal number, and the point counts as on the light.
#[test]
fn no_light_is_made_next_to_its_source() {
    let source = PointLight::new(Vec3::default()).expect("sound").with_attenuation(NoAttenuation);
    let source = source.compile::<f32>().expect("held");
    for exponent in 0..=149 {
        let point = Vec3::new(0.0, 0.5_f32.powi(exponent), 0.0);
        let light = source.irradiance_unskipped(point, Vec3::new(0.0, -1.0, 0.0));
        assert_that!(light <= 1.0 && (light > 0.0) == (exponent < 64), exponent, light);
    }
}

#[test]
fn exponents_beyond_the_domain_are_refused() {
    for refused in [0, 1_025] {
        let accepted = Expected::WholeBetween(1, 1_024);
        assert_refused(IntegerPower::new(refused), Parameter::Exponent, accepted);
        assert_refused(InvertedIntegerPower::new(refused), Parameter::Exponent, accepted);
    }
    for refused in [0.0, -1.0, 1_024.0_f32.next_up(), f32::NAN] {
        let error = RealPower::new(refused).expect_err("outside of the domain");
        assert_eq!((error.parameter, error.accepted), (Parameter::Exponent, Expected::UpTo(1_024.0)));
        assert!(InvertedRealPower::new(refused).is_err());
    }
}

/// The power with the smallest possible exponent is a step: full intensity up to the strip at the
/// edge in which a format bounds only the error of position.
fn assert_least_exponent<S: Format>() {
    let least = RealPower::new(f32::from_bits(1)).expect("more than 0");
    let cone = Cone::from_outer(least, sweep::half(30.0)).expect("a sound angle");
    let falloff = cone.compile::<S>().expect("held");
    let outer = cone.outer_versine();
    let strip = 1.0 - 1.0 / 510.0_f32;
    for u in [0.0, 0.1, 0.9, strip * strip] {
        assert_that!(falloff.at(falloff.versine(u * outer)).exact() > 1.0 - 0.5 / 255.0, S::NAME, u);
    }
    assert_eq!(falloff.at(falloff.versine(outer)), S::ZERO);
}

#[test]
fn the_least_exponent_is_a_step() {
    in_every_format!(assert_least_exponent);
    assert!(RealPower::new(f32::from_bits(1)).expect("accepted").steepness(0.0) >= 1.0);
}

/// The error of clipped light in codes, for a light of this intensity, at points in its cone where
/// the gain is at most `gain`.
fn bright<S: Format>(shape: &Shape<AnyFalloff>, half_degrees: f32, intensity: f32, gain: f64) -> f64 {
    let (mut rng, mut worst) = (Rng::with_seed(9), 0.0_f64);
    let truth = shape.exactly_at(half_degrees);
    let farthest = DVec3::splat(S::FARTHEST.min(16_383.0).into());
    for _ in 0..10_000 * sweep::effort() {
        let distance = (f64::from(intensity) / gain).sqrt() * 30.0_f64.powf(rng.f64());
        let way = sweep::direction(&mut rng);
        let light = DVec3::from_array([0; 3].map(|_| 8.0 * rng.f64()));
        let point = (light + distance * way).clamp(-farthest, farthest);
        let point = sweep::single(sweep::on_grid(point));
        let light = sweep::single(sweep::on_grid(light));
        let off_axis = f64::from(half_degrees).to_radians() * (1.0 - rng.f64().powi(2));
        let axis = sweep::single(sweep::direction_off(&mut rng, way, off_axis));
        let normal = sweep::single(way.map(|c| -c)).map(S::from_f32);
        let spot = SpotLight::new(light, axis, shape.at(half_degrees))
            .and_then(|spot| spot.with_intensity(intensity));
        let spot = spot.expect("in the domain");
        let [from, to] = [light, point].map(|place| S::exact_point(place.map(S::length)));
        let way = to - from;
        let squared = way.length_squared();
        if f64::from(intensity) / squared > gain {
            continue;
        }
        let axis = S::exact_direction(sweep::axis::<S, _, _>(&spot)).normalize();
        let versine = oracle::versine_between(way, axis);
        let share = truth.falloff(versine);
        let cosine = -way.normalize().dot(S::exact_normal(normal));
        let exact = f64::from(intensity) / squared * share * cosine;
        let found =
            S::exact_light(spot.compile::<S>().expect("held").irradiance(point.map(S::length), normal));
        worst = worst.max(255.0 * (found.min(1.0) - exact.min(1.0)).abs());
    }
    worst
}

/// The brightest light that is promised half a code; and the brightest possible light, at points
/// where its gain is no larger.
fn assert_intensities<S: Format>() {
    let brightest = Domain::of::<S>().brightest;
    for shape in four() {
        for half_degrees in [3.0, 30.0] {
            let codes = bright::<S>(&shape, half_degrees, brightest, 4.0 * f64::from(brightest));
            assert_held::<S>("brightest of half a code", &shape, half_degrees, 0.0, codes);
            let codes = bright::<S>(&shape, half_degrees, 1e9, brightest.into());
            assert_held::<S>("brightest of all", &shape, half_degrees, 0.0, codes);
        }
    }
    let (light, above) = (Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
    let spot = SpotLight::new(light, above, four()[0].at(30.0)).expect("sound");
    let (point, normal) = (above.map(S::length), Vec3::new(S::ZERO, S::from_f32(-1.0), S::ZERO));
    for dark in [0.0, f32::from_bits(1), f32::MIN_POSITIVE] {
        let compiled = spot.with_intensity(dark).and_then(|spot| spot.compile::<S>()).expect("accepted");
        assert!(S::exact_light(compiled.irradiance(point, normal)) <= f64::from(dark));
    }
    for refused in [-f32::MIN_POSITIVE, 1e9_f32.next_up(), f32::NAN] {
        let error = spot.with_intensity(refused).expect_err("outside of the domain");
        assert_eq!((error.parameter, error.accepted), (Parameter::Intensity, Expected::Between(0.0, 1e9)));
    }
}

#[test]
fn intensities_hold_at_their_ends() {
    in_every_format!(assert_intensities);
}

/// The largest difference from full intensity, in steps of the format, at points on the axis:
/// multiples of integer axes over the whole range of coordinates.
fn lack_on_axis<S: Format>(shape: &Shape<AnyFalloff>, half_degrees: f32) -> f64 {
    let (mut rng, cone) = (Rng::with_seed(30), shape.at(half_degrees));
    let mut worst = 0.0_f64;
    for _ in 0..2_000 * sweep::effort() {
        let most = [2, 10, 100, 10_000][rng.usize(..4)];
        let axis = [0; 3].map(|_| rng.i32(-most..=most));
        let largest = axis.iter().fold(0, |largest, c| c.abs().max(largest));
        if largest == 0 {
            continue;
        }
        let light = [0; 3].map(|_| rng.i32(-16_383..=16_383));
        let times = rng.i32(1..=(16_384 / largest).max(1));
        let vector = |v: [i32; 3]| Vec3::new(v[0] as f32, v[1] as f32, v[2] as f32);
        let point = vector([0, 1, 2].map(|i| light[i] + times * axis[i]));
        let spot = SpotLight::new(vector(light), vector(axis), cone).expect("a sound axis");
        let found = spot.compile::<S>().expect("held").falloff_at(point.map(S::length));
        worst = worst.max((1.0 - found.exact()) / f64::from(S::STEP));
    }
    worst
}

/// On the axis the falloff is at most `most` steps below 1 in the narrowest cones, and exactly 1
/// from 7.5 degrees on.
fn assert_axis<S: Format>(most: f64) {
    let mut shapes = four();
    let power = IntegerPower::new(128).expect("accepted").into();
    shapes.push(Shape::plain("power 128", power, |t| t.powi(128)));
    let mut worst = 0.0_f64;
    for shape in shapes {
        let narrowest = shape.narrowest::<S>();
        // `Fx16` uses the fine evaluation for its narrowest cones, and the coarse one from 1.5
        // times that angle on.
        for half_degrees in [narrowest, 1.5 * narrowest, 10.0 * narrowest, 7.5, 30.0, 90.0]
            .map(|half| half.clamp(narrowest, 90.0))
        {
            let lack = lack_on_axis::<S>(&shape, half_degrees);
            assert!(
                lack == 0.0 || half_degrees < 7.5,
                "{} {} {half_degrees}: {lack}, expected lack == 0.0 or half_degrees < 7.5",
                S::NAME,
                shape.name
            );
            worst = worst.max(lack);
        }
    }
    println!("{} on the axis: {worst} steps short of one", S::NAME);
    assert!((most / 2.0..=most).contains(&worst), "{}: {worst} steps short of one", S::NAME);
}

#[test]
fn points_on_the_axis_have_all_the_light() {
    assert_axis::<f32>(128.0);
    assert_axis::<Fx32>(320_000.0);
    assert_axis::<Fx16>(3.0);
}
