//! Compiled constants of any bits, including bits that no compiled light has: every point still has
//! a defined result. Run with overflow checks, as `cargo test` does.

use fastrand::Rng;
use luminaire::codegen::{
    CompiledCubic, CompiledQuadratic, CompiledSoftPair, FixedRamp, FloatRamp, Gain16, Gain32,
};
use luminaire::number::{Light16, Light32, Quick, Weight16, Weight32};
use luminaire::{
    Angle, Cone, Fx16, Fx32, Length, Rgb, SpotLight, Vec3,
    attenuation::{AnyAttenuation, CompiledAnyAttenuation, GltfRange},
    display::{CompiledExposure, compress_keep_hue},
    falloff::{
        AnyFalloff, CompiledAnyFalloff, Cubic, Falloff, Hard, IntegerPower, Quadratic, Soft, SoftPair,
    },
    light::{
        CompiledCone, CompiledDirectionalLight, CompiledMaterial, CompiledMeasuredLight, CompiledPointLight,
        CompiledSpotLight, Distribution, LightModel, QuickSpotLight, Row, SurfacePoint, Symmetry,
    },
    number::InversePower,
    specular::{BlinnPhong, DifferenceForm, NoSpecular, Phong, SpecularLobe},
};
use support::{
    arbitrary::{bits, vector},
    assert_that,
    format::Format,
    in_every_format, sweep,
};

/// A format whose constants can be made of any bits.
trait Raw: Format {
    fn any_ramp(rng: &mut Rng) -> Self::Ramp;
    fn any_gain(rng: &mut Rng) -> Self::Gain;
    fn any_weight(rng: &mut Rng) -> Self::Weight;
    fn any_light(rng: &mut Rng) -> Self::Irradiance;
}

macro_rules! raw {
    ($format:ty, $ramp:ident, $gain:expr, $weight:expr, $light:expr) => {
        impl Raw for $format {
            fn any_ramp(rng: &mut Rng) -> Self::Ramp {
                $ramp::from_bits(std::array::from_fn(|_| number(rng) as _))
            }

            fn any_gain(rng: &mut Rng) -> Self::Gain {
                $gain([number(rng) as _, number(rng) as _])
            }

            fn any_weight(rng: &mut Rng) -> Self::Weight {
                $weight(bits(rng) as _)
            }

            fn any_light(rng: &mut Rng) -> Self::Irradiance {
                $light(bits(rng) as _)
            }
        }
    };
}

raw!(
    f32,
    FloatRamp,
    |[bits, _]: [u32; 2]| f32::from_bits(bits),
    |bits: u32| f32::from_bits(bits),
    |bits: u32| { f32::from_bits(bits) }
);
raw!(Fx32, FixedRamp, Gain32::from_bits, Weight32::from_bits, Light32::from_bits);
raw!(Fx16, FixedRamp, Gain16::from_bits, Weight16::from_bits, Light16::from_bits);

/// Any bits or, equally often, a small number, because valid shifts and some versines are small.
fn number(rng: &mut Rng) -> u64 {
    if rng.bool() { bits(rng) } else { rng.u64(..80) }
}

fn color<S: Raw>(rng: &mut Rng) -> Rgb<S> {
    Rgb::default().map(|_: ()| S::scalar_from_bits(bits(rng)))
}

fn any_surface<S: Raw>(rng: &mut Rng) -> SurfacePoint<S> {
    SurfacePoint {
        point: vector(rng, S::length_from_bits),
        normal: vector(rng, S::scalar_from_bits),
        view: vector(rng, S::unit_from_bits),
    }
}

/// Asserts that a light answers on a matte surface and in a row.
fn assert_lights<S: Raw, L: LightModel<S>>(rng: &mut Rng, light: L) {
    for _ in 0..20 {
        let surface = any_surface(rng);
        assert_shades::<S, L, NoSpecular>(rng, &surface, &light, ());
        let points = [(); 40].map(|()| vector(rng, S::length_from_bits));
        let row = Row::new(surface.normal, |i| points[i]);
        row.light(&[light], &mut [(); 40], |(), _, sum| assert_that!(sum != Rgb::default(), light));
        let along = Row::along_x(surface.normal, [points[0].y, points[0].z], |i| points[i].x);
        along.fill(&light, 0, &mut [S::Irradiance::default(); 40]);
    }
}

/// Asserts that a light answers on glossy surfaces. A lobe sees the direction of the light alone,
/// so one kind of light is enough.
fn assert_shines<S: Raw, L: LightModel<S>>(rng: &mut Rng, light: L) {
    for _ in 0..20 {
        let surface = any_surface(rng);
        let lobe = (S::any_ramp(rng), number(rng) as u32);
        assert_shades::<S, L, Phong>(rng, &surface, &light, lobe);
        assert_shades::<S, L, BlinnPhong>(rng, &surface, &light, lobe);
        assert_shades::<S, L, DifferenceForm<Phong, 3>>(rng, &surface, &light, lobe.0);
    }
}

/// Asserts that exposed light of any bits, with and without early-outs, is in [0, 1] after clipping
/// and after compressing.
fn assert_shades<S: Raw, L: LightModel<S>, H: SpecularLobe>(
    rng: &mut Rng,
    surface: &SurfacePoint<S>,
    light: &L,
    highlight: H::Constants<S>,
) {
    let emissive = Rgb::default().map(|_: ()| S::any_light(rng));
    let material =
        CompiledMaterial::<S, H>::from_parts(color(rng), color(rng), emissive, color(rng), highlight);
    let ambient = Rgb::default().map(|_: ()| S::any_light(rng));
    let exposure = CompiledExposure::<S>::from_parts(S::any_gain(rng));
    for reflected in [material.reflect(surface, light), material.reflect_unskipped(surface, light)] {
        let exposed = exposure.expose(material.glow(ambient) + reflected);
        for channel in [compress_keep_hue(exposed).red, S::clip(exposed.green)] {
            assert_that!((0.0..=1.0).contains(&channel.exact()), material, light, surface, channel);
        }
    }
}

fn assert_falls<S: Raw>(rng: &mut Rng, falloff: AnyFalloff, curve: CompiledAnyFalloff<S>) {
    let falloff = CompiledCone::<S, AnyFalloff>::from_parts(S::any_ramp(rng), falloff, curve);
    for _ in 0..50 {
        let intensity = falloff.at(S::versine_from_bits(number(rng))).exact();
        assert_that!((0.0..=1.0).contains(&intensity), falloff, intensity);
    }
    let [_, inverse_square, ..] = any_attenuations(rng);
    assert_spot::<S>(rng, falloff, inverse_square);
}

fn assert_spot<S: Raw>(
    rng: &mut Rng,
    falloff: CompiledCone<S, AnyFalloff>,
    distance: CompiledAnyAttenuation<S>,
) {
    let spot = any_spot(rng, falloff, distance);
    assert_lights(rng, spot);
}

fn any_spot<S: Raw>(
    rng: &mut Rng,
    falloff: CompiledCone<S, AnyFalloff>,
    distance: CompiledAnyAttenuation<S>,
) -> CompiledSpotLight<S, AnyFalloff, AnyAttenuation> {
    CompiledSpotLight::from_parts(
        vector(rng, S::length_from_bits),
        vector(rng, S::unit_from_bits),
        falloff,
        S::scalar_from_bits(bits(rng)),
        distance,
        S::any_gain(rng),
        rng.u32(..40),
        [color(rng), color(rng)],
    )
}

fn any_soft<S: Raw>(rng: &mut Rng) -> CompiledCone<S, AnyFalloff> {
    CompiledCone::from_parts(S::any_ramp(rng), Soft.into(), CompiledAnyFalloff::Soft(Soft))
}

fn any_attenuations<S: Raw>(rng: &mut Rng) -> [CompiledAnyAttenuation<S>; 8] {
    let [a, b, c] = [S::any_gain(rng), S::any_gain(rng), S::any_gain(rng)];
    [
        CompiledAnyAttenuation::Constant((a, ())),
        CompiledAnyAttenuation::InverseSquare((a, ())),
        CompiledAnyAttenuation::Polynomial((S::gain(0.0), [a, b, c])),
        CompiledAnyAttenuation::SmoothRange([a, b]),
        CompiledAnyAttenuation::GltfRange((a, ())),
        CompiledAnyAttenuation::FilamentRange((b, ())),
        CompiledAnyAttenuation::WindowedPolynomial((c, [a, b, c])),
        CompiledAnyAttenuation::WindowedDecay((
            a,
            InversePower::from_bits([rng.u32(..), rng.u32(..), rng.u32(..)]),
        )),
    ]
}

fn assert_distances<S: Raw>(rng: &mut Rng) {
    for distance in any_attenuations(rng) {
        let falloff = any_soft(rng);
        assert_spot::<S>(rng, falloff, distance);
        let colors = [color(rng), color(rng)];
        let (position, intensity) = (vector(rng, S::length_from_bits), S::any_gain(rng));
        let near = rng.u32(..40);
        let point =
            CompiledPointLight::<S, AnyAttenuation>::from_parts(position, distance, intensity, near, colors);
        assert_lights(rng, point);
        let frame = [(); 3].map(|()| vector(rng, S::unit_from_bits));
        let (distribution, outside) = (DISTRIBUTIONS[rng.usize(..6)], S::scalar_from_bits(bits(rng)));
        assert_lights(
            rng,
            CompiledMeasuredLight::<S, AnyAttenuation>::from_parts(
                position,
                frame,
                distribution,
                outside,
                distance,
                intensity,
                near,
                colors,
            ),
        );
    }
}

/// The smallest table, the largest and one between, and sizes and counts that no table has.
const DISTRIBUTIONS: [Distribution<'static>; 6] = [
    Distribution::from_parts(&[1, 65_535], 0, Symmetry::Bilateral),
    Distribution::from_parts(&[65_535; 7], 64, Symmetry::Quadrant),
    Distribution::from_parts(&[], u32::MAX, Symmetry::None),
    Distribution::from_parts(&[1, 2, 65_535, 4], 3, Symmetry::Quadrant),
    Distribution::from_parts(&[65_535; 257 * 257], 257, Symmetry::None),
    Distribution::from_parts(&[0; 17 * 9], 17, Symmetry::Bilateral),
];

/// A row looks at the last of its points first, and takes those between it and the first as being between.
#[test]
fn a_point_out_of_order_is_evaluated() {
    let cone = Cone::soft(Angle::degrees(40.0)).expect("a sound cone");
    let light = SpotLight::new([0.0, 2.0, 0.0], [0.0, -1.0, 0.0], cone).expect("a sound light");
    let light = light.compile_quick::<Fx16>().expect("a light that the format holds");
    let normal = Fx16::normal([0.6, 0.8, 0.0]);
    let [zero, x] = [0.0, 0.1].map(Fx16::length);
    for stray in [i32::MIN, i32::MAX] {
        let place = |i: usize| if i == 20 { Length::from_bits(stray) } else { x };
        let mut arrived = [Light16::default(); 40];
        Row::along_x(normal, [zero; 2], place).fill(&light, 0, &mut arrived);
        let alone = light.irradiance(Vec3::new(x, zero, zero), normal);
        assert!((0..40).all(|i| i == 20 || arrived[i] == alone), "{arrived:?}");
    }
}

#[test]
fn any_bits_make_a_quick_light() {
    fn assert_quick<S: Raw + Quick>() {
        let mut rng = Rng::with_seed(0x0b17);
        for _ in 0..300 * sweep::effort() {
            let rng = &mut rng;
            let falloff = CompiledCone::<S, _>::from_parts(S::any_ramp(rng), Hard, Hard);
            let (position, axis) = (vector(rng, S::length_from_bits), vector(rng, S::unit_from_bits));
            let colors = [color(rng), color(rng)];
            let (gain, range) = (S::any_gain(rng), S::any_gain(rng));
            let outside = S::scalar_from_bits(bits(rng));
            let light = QuickSpotLight::<S, _, GltfRange>::from_parts(
                position,
                axis,
                falloff,
                outside,
                (range, ()),
                gain,
                colors,
            );
            assert_lights(rng, light);
            for _ in 0..7 {
                let cone = CompiledCone::from_parts(S::any_ramp(rng), Hard, Hard);
                let other =
                    QuickSpotLight::from_parts(position, axis, cone, outside, (range, ()), gain, colors);
                let part = S::scalar_from_bits(bits(rng));
                assert_lights(rng, light.zoomed(&other, part));
            }
        }
    }
    assert_quick::<Fx16>();
}

fn assert_any_bits_zoom<S: Raw>() {
    let mut rng = Rng::with_seed(0x0b17);
    for _ in 0..2_000 * sweep::effort() {
        let rng = &mut rng;
        let part = S::scalar_from_bits(bits(rng));
        let full = [(); 2].map(|()| {
            let (falloff, [_, inverse_square, ..]) = (any_soft(rng), any_attenuations(rng));
            any_spot(rng, falloff, inverse_square)
        });
        let zoomed = full[0].zoomed(&full[1], part);
        assert_lights(rng, zoomed);
        for _ in 0..20 {
            let intensity = zoomed.falloff_at(vector(rng, S::length_from_bits)).exact();
            assert_that!((0.0..=1.0).contains(&intensity), full, part, intensity);
        }
    }
}

#[test]
fn any_bits_zoom() {
    in_every_format!(assert_any_bits_zoom);
}

fn assert_any_bits_make_a_light<S: Raw>() {
    let mut rng = Rng::with_seed(0xb175);
    for _ in 0..300 * sweep::effort() {
        let rng = &mut rng;
        let quadratic = CompiledQuadratic::from_parts(S::any_weight(rng));
        let cubic = CompiledCubic::from_parts(S::any_weight(rng), S::any_weight(rng));
        assert_falls::<S>(rng, Soft.into(), CompiledAnyFalloff::Soft(Soft));
        assert_falls::<S>(rng, Hard.into(), CompiledAnyFalloff::Hard(Hard));
        let power = IntegerPower::new(15).expect("sound");
        assert_falls::<S>(rng, power.into(), CompiledAnyFalloff::Power(power));
        let raw = Quadratic::from_bits(bits(rng) as u32);
        assert_falls::<S>(rng, raw.into(), CompiledAnyFalloff::Quadratic(quadratic));
        let raw = Cubic::from_bits([bits(rng) as u32, bits(rng) as u32]);
        assert_falls::<S>(rng, raw.into(), CompiledAnyFalloff::Cubic(cubic));
        let pair = CompiledSoftPair::from_parts(S::any_weight(rng), S::any_gain(rng));
        let raw = SoftPair::from_bits([bits(rng) as u32, bits(rng) as u32]);
        assert_falls::<S>(rng, raw.into(), CompiledAnyFalloff::SoftPair(pair));
        assert_distances::<S>(rng);
        let colors = [color(rng), color(rng)];
        let (direction, intensity) = (vector(rng, S::unit_from_bits), S::any_gain(rng));
        let sun = CompiledDirectionalLight::<S>::from_parts(direction, intensity, colors);
        assert_lights(rng, sun);
        assert_shines(rng, sun);
    }
}

#[test]
fn any_bits_make_a_light_in_f32() {
    assert_any_bits_make_a_light::<f32>();
}

#[test]
fn any_bits_make_a_light_in_fx32() {
    assert_any_bits_make_a_light::<Fx32>();
}

#[test]
fn any_bits_make_a_light_in_fx16() {
    assert_any_bits_make_a_light::<Fx16>();
}

/// Any bits or, equally often, a NaN of any payload.
fn float_bits(rng: &mut Rng) -> u32 {
    let bits = rng.u32(..);
    if rng.bool() { bits | 0x7f80_0001 } else { bits }
}

/// Asserts that the figures of a falloff, and of cones made with it, are in range.
fn assert_figures<P: Falloff + PartialEq>(rng: &mut Rng, falloff: P) {
    for figure in [falloff.beam_versine(), falloff.field_versine(), falloff.integral(rng.f32())] {
        assert_that!((0.0..=1.0).contains(&figure), falloff, figure);
    }
    for hotspot in [0.0, 0.99 * rng.f32()] {
        let steepness = falloff.steepness(hotspot);
        assert_that!(steepness >= 0.0 && steepness.is_finite(), falloff, hotspot, steepness);
    }
    let cone = Cone::from_outer(falloff, Angle::degrees(1.0 + 179.0 * rng.f32())).expect("a sound angle");
    for flux in [cone.lumens(1000.0), cone.candela(1000.0)] {
        assert_that!(flux > 0.0 && flux.is_finite(), cone, flux);
    }
    assert_that!(Cone::narrowest::<Fx16>(falloff).to_degrees().is_finite(), falloff);
}

#[test]
fn any_bits_make_a_profile_with_figures() {
    let mut rng = Rng::with_seed(0x0b17_5eed);
    for _ in 0..3000 * sweep::effort() {
        let quadratic = Quadratic::from_bits(float_bits(&mut rng));
        assert_that!((0.0..=2.0).contains(&quadratic.edge_slope()), quadratic);
        assert_figures(&mut rng, quadratic);
        let cubic = Cubic::from_bits([float_bits(&mut rng), float_bits(&mut rng)]);
        for slope in [cubic.edge_slope(), cubic.middle_slope()] {
            assert_that!((0.0..=4.0).contains(&slope), cubic);
        }
        assert_figures(&mut rng, cubic);
    }
}
