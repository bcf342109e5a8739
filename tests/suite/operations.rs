//! Accuracy of every operation of the seam in all three formats against f64, row by row of
//! `tests/bounds.csv`. `LUMINAIRE_FULL=1 cargo test --test suite -- operations:: setup::
//! --nocapture --test-threads 1` prints the measured ones.
//!
//! Operands are values that the format has stored, so that an error is that of the operation alone.
//! Errors of scalars and of light are in steps of the format, errors of gains are relative, and
//! errors of directions are in radians.

use fastrand::Rng;
use luminaire::{
    AmbientLight, Cone, DirectionalLight, Fx16, Fx32, Material, Rgb, Vec3,
    display::Exposure,
    falloff::{Linear, Soft},
    number::{Fraction, Gain, Light16, Light32, Lights, Offset, Ray, Share},
};
use support::{
    bounds,
    format::Format,
    in_every_format,
    oracle::{self, DVec3},
    sweep,
};

/// The largest of the errors that a search finds.
fn largest(mut error: impl FnMut(&mut Rng) -> f64) -> f64 {
    let mut rng = Rng::with_seed(1_000);
    (0..20_000 * sweep::effort()).map(|_| error(&mut rng)).fold(0.0, f64::max)
}

macro_rules! assert_in_every_format {
    ($name:literal, $error:ident) => {
        bounds::assert_row(
            "operation",
            $name,
            [largest($error::<f32>), largest($error::<Fx32>), largest($error::<Fx16>)],
        )
    };
}

fn steps<S: Format>(error: f64) -> f64 {
    error.abs() / f64::from(S::STEP)
}

/// A scalar from -1 to 1.
fn scalar<S: Format>(rng: &mut Rng) -> S {
    S::from_f32(2.0 * rng.f32() - 1.0)
}

/// A 16-bit number times a power of two from `2^least` to `2^most`, which every format represents
/// exactly as a gain.
fn sixteen_bits(rng: &mut Rng, least: i32, most: i32) -> f32 {
    rng.u32(1 << 15..1 << 16) as f32 * 2.0_f32.powi(rng.i32(least..most) - 15)
}

/// The value of a gain, read as light after scaling it by `2^up`.
fn value<S: Format>(gain: S::Gain, up: i32) -> f64 {
    let factor = 2.0_f32.powi(up);
    S::exact_light(S::ONE.light(gain.times(S::gain(factor)))) / f64::from(factor)
}

fn relative(found: f64, exact: f64) -> f64 {
    (found / exact - 1.0).abs()
}

fn direction<S: Format>(rng: &mut Rng) -> Vec3<S::Unit> {
    S::axis(sweep::single(sweep::direction(rng)))
}

fn normal<S: Format>(rng: &mut Rng) -> Vec3<S> {
    sweep::single(sweep::direction(rng)).map(S::from_f32)
}

/// The angle between two directions, in radians.
fn angle(a: DVec3, b: DVec3) -> f64 {
    (2.0 * oracle::versine_between(a, b)).sqrt()
}

/// The way from a light to a point, and the exact one.
fn offset<S: Format>(rng: &mut Rng) -> (S::Offset, DVec3) {
    let light = sweep::position(rng);
    let (way, distance) = (sweep::direction(rng), sweep::distance(rng));
    let point = sweep::on_grid(light + distance * way);
    let [from, to] = [light, point].map(|v| sweep::single(v).map(S::length));
    (S::Offset::between(from, to), S::exact_point(to) - S::exact_point(from))
}

fn times<S: Format>(rng: &mut Rng) -> f64 {
    let (a, b) = (S::from_f32(rng.f32()), S::from_f32(rng.f32()));
    steps::<S>(a.times(b).exact() - a.exact() * b.exact())
}

fn difference<S: Format>(rng: &mut Rng) -> f64 {
    let (a, b) = (scalar::<S>(rng), scalar::<S>(rng));
    steps::<S>(a.minus(b).exact() - (a.exact() - b.exact()))
}

fn smooth<S: Format>(rng: &mut Rng) -> f64 {
    let t = S::from_f32(rng.f32());
    steps::<S>(t.smooth().exact() - oracle::smooth(t.exact()))
}

/// The value in f32, relative.
fn to_f32<S: Format>(rng: &mut Rng) -> f64 {
    let value = S::from_f32(0.5 + 0.5 * rng.f32()).times(S::from_f32(0.5 + 0.5 * rng.f32()));
    relative(value.to_f32().into(), value.exact())
}

#[test]
fn scalars_keep_their_rows() {
    assert_in_every_format!("times", times);
    assert_in_every_format!("minus", difference);
    assert_in_every_format!("smooth", smooth);
    assert_in_every_format!("to f32 relative", to_f32);
}

fn gain<S: Format>(rng: &mut Rng) -> f64 {
    let exact = 1.0 + rng.f32();
    relative(value::<S>(S::gain(exact), 14), exact.into())
}

fn gain_times<S: Format>(rng: &mut Rng) -> f64 {
    let [a, b] = [0; 2].map(|_| sixteen_bits(rng, -2, 2));
    relative(value::<S>(S::gain(a).times(S::gain(b)), 12), f64::from(a) * f64::from(b))
}

fn gain_plus<S: Format>(rng: &mut Rng) -> f64 {
    let [a, b] = [0; 2].map(|_| sixteen_bits(rng, -4, 2));
    relative(value::<S>(S::gain(a).plus(S::gain(b)), 12), f64::from(a) + f64::from(b))
}

fn inverse_capped<S: Format>(rng: &mut Rng) -> f64 {
    let a = sixteen_bits(rng, -1, 4);
    relative(value::<S>(S::gain(a).inverse_capped(), 16), (1.0 / f64::from(a)).min(1.0))
}

fn gain_scalar<S: Format>(rng: &mut Rng) -> f64 {
    let a = sixteen_bits(rng, -6, 1);
    steps::<S>(S::gain(a).scalar().exact() - f64::from(a).min(1.0))
}

#[test]
fn gains_keep_their_rows() {
    assert_in_every_format!("gain relative", gain);
    assert_in_every_format!("gain times relative", gain_times);
    assert_in_every_format!("gain plus relative", gain_plus);
    assert_in_every_format!("inverse capped relative", inverse_capped);
    assert_in_every_format!("scalar of a gain", gain_scalar);
}

/// Light of up to four times full scale.
fn light<S: Format>(rng: &mut Rng) -> S::Irradiance {
    S::from_f32(rng.f32()).light(S::gain(4.0))
}

fn share_light<S: Format>(rng: &mut Rng) -> f64 {
    let (fraction, gain) = (S::from_f32(rng.f32()), sixteen_bits(rng, -3, 0));
    steps::<S>(S::exact_light(fraction.light(S::gain(gain))) - fraction.exact() * f64::from(gain))
}

fn filter<S: Format>(rng: &mut Rng) -> f64 {
    let (light, color) = (light::<S>(rng), S::from_f32(rng.f32()));
    steps::<S>(S::exact_light(S::filter(light, color)) - S::exact_light(light) * color.exact())
}

fn add_light<S: Format>(rng: &mut Rng) -> f64 {
    let (a, b) = (light::<S>(rng), light::<S>(rng));
    steps::<S>(S::exact_light(a + b) - (S::exact_light(a) + S::exact_light(b)))
}

fn light_to_f32<S: Format>(rng: &mut Rng) -> f64 {
    let light = S::filter(light::<S>(rng), S::from_f32(0.5 + 0.5 * rng.f32()));
    let exact = S::exact_light(light);
    if exact > 0.0 { relative(S::light_to_f32(light).into(), exact) } else { 0.0 }
}

fn light_to_gain<S: Format>(rng: &mut Rng) -> f64 {
    let light = S::from_f32(0.5 + 0.5 * rng.f32()).light(S::gain(16.0));
    relative(value::<S>(S::light_to_gain(light), 12), S::exact_light(light))
}

/// Multiplies light by a gain of a size that occurs in an exposure or in keeping the hue.
fn amplify<S: Format>(rng: &mut Rng) -> f64 {
    let (light, gain) = (light::<S>(rng), sixteen_bits(rng, -3, 0));
    steps::<S>(S::exact_light(S::amplify(light, S::gain(gain))) - S::exact_light(light) * f64::from(gain))
}

fn clip<S: Format>(rng: &mut Rng) -> f64 {
    let light = light::<S>(rng);
    steps::<S>(S::clip(light).exact() - S::exact_light(light).min(1.0))
}

/// An exposure of any factor from 1/8 to 1, the rounding of the factor included.
fn exposure<S: Format>(rng: &mut Rng) -> f64 {
    let (light, factor) = (light::<S>(rng), 0.125 + 0.875 * rng.f32());
    let exposed =
        Exposure::factor(factor).expect("sound").compile::<S>().expose(Rgb::new(light, light, light));
    steps::<S>(S::exact_light(exposed.green) - S::exact_light(light) * f64::from(factor))
}

fn grey(value: f32) -> Rgb<f32> {
    Rgb::new(value, value, value)
}

/// Compiled ambient light, reflected by a material that also emits light, with the roundings of
/// both.
fn glow<S: Format>(rng: &mut Rng) -> f64 {
    let [color, ambient, emissive, intensity] = [0; 4].map(|_| rng.f32());
    let light =
        AmbientLight::new(grey(color)).and_then(|light| light.with_intensity(intensity)).expect("sound");
    let material = Material::new(grey(0.0))
        .and_then(|material| material.with_ambient(grey(ambient)))
        .and_then(|material| material.with_emissive(grey(emissive)))
        .expect("sound");
    let found = material.compile::<S>().glow(light.compile::<S>()).blue;
    let [color, ambient, emissive, intensity] = [color, ambient, emissive, intensity].map(f64::from);
    steps::<S>(S::exact_light(found) - (color * intensity * ambient + emissive))
}

/// A grey light in a colour, after a filter, and a second light added to it.
fn colored<S: Format>(rng: &mut Rng) -> f64 {
    let (a, b) = (light::<S>(rng), light::<S>(rng));
    let [color, filter] = [0; 2].map(|_| S::from_f32(rng.f32()));
    let rgb = |value: S| Rgb::new(value, value, value);
    let lit = (Rgb::lit(a, rgb(color)).filtered(rgb(filter)) + Rgb::new(b, b, b)).red;
    let exact = S::exact_light(a) * color.exact() * filter.exact() + S::exact_light(b);
    steps::<S>(S::exact_light(lit) - exact)
}

#[test]
fn light_keeps_its_rows() {
    assert_in_every_format!("light of a share", share_light);
    assert_in_every_format!("filter", filter);
    assert_in_every_format!("add light", add_light);
    assert_in_every_format!("light to f32 relative", light_to_f32);
    assert_in_every_format!("light to gain relative", light_to_gain);
    assert_in_every_format!("amplify", amplify);
    assert_in_every_format!("clip", clip);
    assert_in_every_format!("exposure", exposure);
    assert_in_every_format!("ambient light and glow", glow);
    assert_in_every_format!("light filter and sum", colored);
}

fn axis<S: Format>(rng: &mut Rng) -> f64 {
    let given = sweep::single(sweep::direction(rng));
    angle(S::exact_direction(S::axis(given)), f32::exact_direction(given))
}

fn normal_unit<S: Format>(rng: &mut Rng) -> f64 {
    let normal = normal::<S>(rng);
    angle(S::exact_direction(S::normal_unit(normal)), S::exact_normal(normal))
}

fn mirror<S: Format>(rng: &mut Rng) -> f64 {
    let (direction, normal) = (direction::<S>(rng), normal::<S>(rng));
    let exact = S::exact_direction(direction).reflect(S::exact_normal(normal));
    angle(S::exact_direction(S::mirror(direction, normal)), exact)
}

/// The half vector of two directions that differ by at least a tenth.
fn direction_between<S: Format>(rng: &mut Rng) -> f64 {
    let (a, b) = (direction::<S>(rng), direction::<S>(rng));
    let exact = S::exact_direction(b) - S::exact_direction(a);
    if exact.length_squared() < 0.01 {
        return 0.0;
    }
    angle(S::exact_direction(S::direction_between(a, b)), exact)
}

fn incidence<S: Format>(rng: &mut Rng) -> f64 {
    let (direction, normal) = (direction::<S>(rng), normal::<S>(rng));
    let exact = -S::exact_direction(direction).dot(S::exact_normal(normal));
    steps::<S>(S::incidence(direction, normal).exact() - exact.clamp(0.0, 1.0))
}

/// The versine of two directions up to the edge of a cone of 10 degrees, relative to its outer
/// versine.
fn versine_between<S: Format>(rng: &mut Rng) -> f64 {
    let cone = Cone::from_outer(Linear, sweep::half(10.0)).expect("sound");
    let (falloff, outer) = (cone.compile::<S>().expect("held"), cone.outer_versine());
    let a = sweep::direction(rng);
    let off = 9.9_f64.to_radians() * rng.f64();
    let b = sweep::direction_off(rng, a, off);
    let [a, b] = [a, b].map(|v| S::axis(sweep::single(v)));
    let apart = S::exact_direction(a) - S::exact_direction(b);
    let found = S::versine_between(a, b, S::ramp(0.0, outer, outer));
    (S::exact_versine(&falloff, found) - apart.length_squared() / 2.0).abs() / f64::from(outer)
}

/// The nearest versine in the scale of a cone of 10 degrees, relative to its outer versine.
fn versine<S: Format>(rng: &mut Rng) -> f64 {
    let cone = Cone::from_outer(Linear, sweep::half(10.0)).expect("sound");
    let (falloff, outer) = (cone.compile::<S>().expect("held"), cone.outer_versine());
    let value = outer * rng.f32();
    (S::exact_versine(&falloff, falloff.versine(value)) - f64::from(value)).abs() / f64::from(outer)
}

/// The 32nd power of a cosine from its versine.
fn power<S: Format>(rng: &mut Rng) -> f64 {
    let falloff = Cone::from_outer(Linear, sweep::half(90.0)).expect("sound").compile::<S>().expect("held");
    let versine = falloff.versine(0.2 * rng.f32());
    let exact = (1.0 - S::exact_versine(&falloff, versine)).powi(32);
    steps::<S>(S::power(versine, 32).exact() - exact)
}

#[test]
fn directions_keep_their_rows() {
    assert_in_every_format!("axis radians", axis);
    assert_in_every_format!("normal unit radians", normal_unit);
    assert_in_every_format!("mirror radians", mirror);
    assert_in_every_format!("direction between radians", direction_between);
    assert_in_every_format!("incidence", incidence);
    assert_in_every_format!("versine between of the outer", versine_between);
    assert_in_every_format!("versine of the outer", versine);
    assert_in_every_format!("power 32", power);
}

fn ray_direction<S: Format>(rng: &mut Rng) -> f64 {
    let (offset, way) = offset::<S>(rng);
    angle(S::exact_direction(offset.ray().direction()), way) / f64::from(S::DIRECTION_ERROR)
}

fn ray_length<S: Format>(rng: &mut Rng) -> f64 {
    let (offset, _) = offset::<S>(rng);
    let direction = S::exact_direction(offset.ray().direction());
    relative(direction.length(), 1.0)
}

fn ray_distance<S: Format>(rng: &mut Rng) -> f64 {
    let (offset, way) = offset::<S>(rng);
    relative(value::<S>(offset.ray().distance(), 11), way.length())
}

fn squared_distance<S: Format>(rng: &mut Rng) -> f64 {
    let (offset, way) = offset::<S>(rng);
    relative(value::<S>(offset.squared_distance(), 6), way.length_squared())
}

/// Lambert's cosine, in steps. A surface that faces away by more than a step is detected; in
/// `Fx32`, which tests 15 bits of the offset, by more than 0.001.
fn ray_cosine<S: Format>(rng: &mut Rng) -> f64 {
    let ((offset, way), normal) = (offset::<S>(rng), normal::<S>(rng));
    let exact = -way.normalize().dot(S::exact_normal(normal));
    let facing = offset.facing(normal);
    if exact.abs() > if S::NAME == "fx32" { 1e-3 } else { 4.0 * f64::from(S::STEP) } {
        assert_eq!(S::Offset::faces_away(facing), exact < 0.0, "{} {exact}", S::NAME);
    }
    let cosine = offset.ray().cosine(facing, normal);
    assert_eq!(cosine.times_value(Share::of_scalar(S::ONE)), cosine.value());
    let half = Share::of_scalar(S::from_f32(0.5));
    steps::<S>(2.0 * cosine.times_value(half).scalar().exact() - exact.clamp(0.0, 1.0))
}

fn ray_versine<S: Format>(rng: &mut Rng) -> f64 {
    let cone = Cone::from_outer(Soft, sweep::half(10.0)).expect("sound");
    let (falloff, outer) = (cone.compile::<S>().expect("held"), cone.outer_versine());
    let (offset, way) = offset::<S>(rng);
    let off = 9.9_f64.to_radians() * rng.f64();
    let axis = S::axis(sweep::single(sweep::direction_off(rng, way.normalize(), off)));
    let found = S::versine_between(offset.ray().direction(), axis, S::ramp(0.0, outer, outer));
    let exact = oracle::versine_between(way, S::exact_direction(axis));
    (S::exact_versine(&falloff, found) - exact).abs() / f64::from(outer)
}

/// The relative error of the inverse square, for light of 16 to 64 times full scale, where the
/// rounding of the light itself is negligible.
fn ray_light<S: Format>(rng: &mut Rng) -> f64 {
    let (offset, way) = offset::<S>(rng);
    let squared = way.length_squared();
    let gain = (squared * (16.0 + 48.0 * rng.f64())) as f32;
    let exact = f64::from(gain) / squared;
    relative(S::exact_light(offset.ray().light(Share::of_scalar(S::ONE), S::gain(gain))), exact)
}

/// Lambert's cosine of directional light with intensities up to full scale.
fn directional<S: Format>(rng: &mut Rng) -> f64 {
    let (direction, normal, intensity) = (sweep::direction(rng), normal::<S>(rng), 0.5 + 0.5 * rng.f32());
    let sun = DirectionalLight::new(sweep::single(direction)).and_then(|sun| sun.with_intensity(intensity));
    let sun = sun.expect("sound");
    let exact = -f32::exact_direction(sun.given_direction()).normalize().dot(S::exact_normal(normal));
    let found = S::exact_light(sun.compile::<S>().irradiance(normal));
    steps::<S>(found - f64::from(intensity) * exact.clamp(0.0, 1.0))
}

#[test]
fn parallel_light_keeps_its_row() {
    assert_in_every_format!("directional light", directional);
}

#[test]
fn rays_keep_their_rows() {
    assert_in_every_format!("ray direction of the stated", ray_direction);
    assert_in_every_format!("ray direction its length", ray_length);
    assert_in_every_format!("ray distance relative", ray_distance);
    assert_in_every_format!("squared distance relative", squared_distance);
    assert_in_every_format!("ray cosine", ray_cosine);
    assert_in_every_format!("ray versine of the outer", ray_versine);
    assert_in_every_format!("ray light relative", ray_light);
}

/// In fixed point a light in a colour is the product, rounded once and at most the largest light:
/// over the whole range of both.
#[test]
fn a_filter_is_the_nearest_product_or_the_largest_light() {
    macro_rules! assert_nearest {
        ($rng:ident, $scalar:ident, $light:ident, $bits:ident) => {
            for _ in 0..20_000 * sweep::effort() {
                // Of any length, from one bit to all.
                let light = $light::from_bits($rng.u64(..) as $bits >> $rng.u32(0..$bits::BITS));
                let color = $scalar::from_bits($rng.i32(..) as _);
                let positive = color.to_bits().max(0) as u128;
                let product = u128::from(light.to_bits()) * positive;
                let half = 1 << ($scalar::FRACTION_BITS - 1);
                let nearest = ((product + half) >> $scalar::FRACTION_BITS).min($bits::MAX.into());
                let found = u128::from($scalar::filter(light, color).to_bits());
                assert_eq!(found, nearest, "{light:?} {color:?}");
            }
        };
    }
    let mut rng = Rng::with_seed(1_001);
    assert_nearest!(rng, Fx16, Light16, u32);
    assert_nearest!(rng, Fx32, Light32, u64);
}

/// Nothing is added to a gain without a rounding, from either side.
#[test]
fn a_gain_and_nothing_is_the_gain() {
    fn assert_neutral<S: Format>() {
        let mut rng = Rng::with_seed(1_002);
        let nothing = S::gain(0.0);
        for _ in 0..1_000 {
            let gain = S::gain(rng.f32() * 2.0_f32.powi(rng.i32(-40..10)));
            for sum in [gain.plus(nothing), nothing.plus(gain)] {
                assert_eq!(sum, gain, "{}", S::NAME);
            }
        }
    }
    in_every_format!(assert_neutral);
}
