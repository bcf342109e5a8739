//! Compiled constants of any bits, including bits that no compiled light has: every point still has
//! a defined result. Run with overflow checks, as `cargo test` does.

use fastrand::Rng;
use luminaire::codegen::{CompiledCubic, CompiledQuadratic, FloatRamp, Gain16, Gain32, Ramp16, Ramp32};
use luminaire::number::{Light16, Light32, Weight16, Weight32};
use luminaire::{
    Angle, Cone, Fx16, Fx32, Rgb,
    attenuation::{
        Attenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
    },
    display::{CompiledExposure, compress_keep_hue},
    falloff::{Cubic, Falloff, Hard, Power, Quadratic, Soft},
    light::{
        CompiledCone, CompiledDirectionalLight, CompiledMaterial, CompiledPointLight, CompiledSpotLight,
        LightModel, QuickCone, QuickSpotLight, Row, SurfacePoint,
    },
    specular::{BlinnPhong, DifferenceForm, NoSpecular, Phong, SpecularLobe},
};
use support::arbitrary::{bits, vector};
use support::format::Format;
use support::sweep;

/// A format whose constants can be made of any bits.
trait Raw: Format {
    fn any_ramp(rng: &mut Rng) -> Self::Ramp;
    fn any_quick_ramp(rng: &mut Rng) -> Self::QuickRamp;
    fn any_gain(rng: &mut Rng) -> Self::Gain;
    fn any_weight(rng: &mut Rng) -> Self::Weight;
    fn any_light(rng: &mut Rng) -> Self::Irradiance;
}

macro_rules! raw {
    ($format:ty, $ramp:ident, $quick_ramp:ident, $gain:expr, $weight:expr, $light:expr) => {
        impl Raw for $format {
            fn any_ramp(rng: &mut Rng) -> Self::Ramp {
                $ramp::from_bits(std::array::from_fn(|_| number(rng) as _))
            }

            fn any_quick_ramp(rng: &mut Rng) -> Self::QuickRamp {
                $quick_ramp::from_bits(std::array::from_fn(|_| number(rng) as _))
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
    FloatRamp,
    |[bits, _]: [u32; 2]| f32::from_bits(bits),
    |bits: u32| f32::from_bits(bits),
    |bits: u32| { f32::from_bits(bits) }
);
raw!(Fx32, Ramp32, Ramp16, Gain32::from_bits, Weight32::from_bits, Light32::from_bits);
raw!(Fx16, Ramp16, Ramp16, Gain16::from_bits, Weight16::from_bits, Light16::from_bits);

/// Any bits or, equally often, a small number, because valid shifts and some versines are small.
fn number(rng: &mut Rng) -> u64 {
    if rng.bool() { bits(rng) } else { rng.u64(..80) }
}

fn color<S: Raw>(rng: &mut Rng) -> Rgb<S> {
    Rgb::default().map(|_: ()| S::scalar_from_bits(bits(rng)))
}

fn assert_lights<S: Raw, L: LightModel<S>>(rng: &mut Rng, light: L) {
    for _ in 0..20 {
        let surface = SurfacePoint {
            point: vector(rng, S::length_from_bits),
            normal: vector(rng, S::scalar_from_bits),
            view: vector(rng, S::unit_from_bits),
        };
        assert_shades::<S, L, NoSpecular>(rng, &surface, &light, ());
        let points = [(); 40].map(|()| vector(rng, S::length_from_bits));
        let row = Row::new(surface.normal, |i| points[i]);
        row.light(&[light], &mut [(); 40], |(), _, sum| assert!(sum != Rgb::default()));
        let lobe = (S::any_ramp(rng), number(rng) as u32);
        assert_shades::<S, L, Phong>(rng, &surface, &light, lobe);
        assert_shades::<S, L, BlinnPhong>(rng, &surface, &light, lobe);
        assert_shades::<S, L, DifferenceForm<Phong, 3>>(rng, &surface, &light, lobe.0);
    }
}

/// Asserts that exposed light of any bits is in [0, 1] after clipping and after compressing.
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
    let sum = material.glow(ambient).plus::<S>(material.reflect(surface, light));
    let exposed = CompiledExposure::<S>::from_parts(S::any_gain(rng)).expose(sum);
    for channel in [compress_keep_hue::<S>(exposed).red, S::clip(exposed.green)] {
        assert!((0.0..=1.0).contains(&channel.exact()), "{material:?} {light:?} {surface:?}: {channel:?}");
    }
}

fn assert_falls<S: Raw, P: Falloff + PartialEq>(rng: &mut Rng, profile: P, curve: P::Compiled<S>) {
    let falloff = CompiledCone::<S, P>::from_parts(S::any_ramp(rng), profile, curve);
    for _ in 0..50 {
        let intensity = falloff.at(S::versine_from_bits(number(rng))).exact();
        assert!((0.0..=1.0).contains(&intensity), "{falloff:?}: {intensity}");
    }
    assert_spot::<S, P, InverseSquare>(rng, falloff, ());
}

fn assert_spot<S: Raw, P: Falloff, A: Attenuation>(
    rng: &mut Rng,
    falloff: CompiledCone<S, P>,
    distance: A::Constants<S>,
) {
    let (position, axis) = (vector(rng, S::length_from_bits), vector(rng, S::unit_from_bits));
    let colors = [color(rng), color(rng)];
    let outside = S::scalar_from_bits(bits(rng));
    let spot = CompiledSpotLight::<S, P, A>::from_parts(
        position,
        axis,
        falloff,
        outside,
        distance,
        S::any_gain(rng),
        rng.u32(..40),
        colors,
    );
    assert_lights(rng, spot);
}

fn assert_distances<S: Raw>(rng: &mut Rng) {
    let falloff = CompiledCone::from_parts(S::any_ramp(rng), Soft, Soft);
    assert_distance::<S, NoAttenuation>(rng, falloff, ());
    let [a, b, c] = [S::any_gain(rng), S::any_gain(rng), S::any_gain(rng)];
    assert_distance::<S, Polynomial>(rng, falloff, [a, b, c]);
    assert_distance::<S, SmoothRange>(rng, falloff, [a, b]);
    assert_distance::<S, GltfRange>(rng, falloff, (a, ()));
    assert_distance::<S, FilamentRange>(rng, falloff, (b, ()));
    assert_distance::<S, CutAt<SmoothRange>>(rng, falloff, (c, [a, b]));
}

fn assert_distance<S: Raw, A: Attenuation>(
    rng: &mut Rng,
    falloff: CompiledCone<S, Soft>,
    distance: A::Constants<S>,
) {
    assert_spot::<S, Soft, A>(rng, falloff, distance);
    let colors = [color(rng), color(rng)];
    let (position, intensity) = (vector(rng, S::length_from_bits), S::any_gain(rng));
    let point = CompiledPointLight::<S, A>::from_parts(position, distance, intensity, rng.u32(..40), colors);
    assert_lights(rng, point);
    let direction = vector(rng, S::unit_from_bits);
    assert_lights(rng, CompiledDirectionalLight::<S>::from_parts(direction, intensity, colors));
}

#[test]
fn any_bits_make_a_quick_light() {
    fn assert_quick<S: Raw>() {
        let mut rng = Rng::with_seed(0x0b17);
        for _ in 0..300 * sweep::effort() {
            let rng = &mut rng;
            let falloff = QuickCone::<S, _>::from_parts(S::any_quick_ramp(rng), Hard, Hard);
            let (position, axis) = (vector(rng, S::length_from_bits), vector(rng, S::unit_from_bits));
            let colors = [color(rng), color(rng)];
            let (gain, range) = (S::any_gain(rng), S::any_gain(rng));
            let light = QuickSpotLight::<S, _, GltfRange>::from_parts(
                position,
                axis,
                falloff,
                (range, ()),
                gain,
                colors,
            );
            assert_lights(rng, light);
        }
    }
    assert_quick::<f32>();
    assert_quick::<Fx32>();
    assert_quick::<Fx16>();
}

fn assert_any_bits_zoom<S: Raw>() {
    let mut rng = Rng::with_seed(0x0b17);
    for _ in 0..2_000 * sweep::effort() {
        let rng = &mut rng;
        let (position, axis) = (vector(rng, S::length_from_bits), vector(rng, S::unit_from_bits));
        let colors = [color(rng), color(rng)];
        let (gain, part) = (S::any_gain(rng), S::scalar_from_bits(bits(rng)));
        let full = [(); 2].map(|()| {
            let (cone, outside) = (CompiledCone::from_parts(S::any_ramp(rng), Soft, Soft), bits(rng));
            let outside = S::scalar_from_bits(outside);
            let near = rng.u32(..40);
            CompiledSpotLight::<S, _>::from_parts(position, axis, cone, outside, (), gain, near, colors)
        });
        let zoomed = full[0].zoomed(&full[1], part);
        assert_lights(rng, zoomed);
        for _ in 0..20 {
            let intensity = zoomed.falloff(vector(rng, S::length_from_bits)).exact();
            assert!((0.0..=1.0).contains(&intensity), "{full:?} {part:?}: {intensity}");
        }
        let quick = [(); 2].map(|()| {
            let cone = QuickCone::from_parts(S::any_quick_ramp(rng), Soft, Soft);
            QuickSpotLight::<S, _>::from_parts(position, axis, cone, (), gain, colors)
        });
        assert_lights(rng, quick[0].zoomed(&quick[1], part));
    }
}

#[test]
fn any_bits_zoom() {
    assert_any_bits_zoom::<f32>();
    assert_any_bits_zoom::<Fx32>();
    assert_any_bits_zoom::<Fx16>();
}

fn assert_any_bits_make_a_light<S: Raw>() {
    let mut rng = Rng::with_seed(0xb175);
    for _ in 0..300 * sweep::effort() {
        let rng = &mut rng;
        let quadratic = CompiledQuadratic::from_parts(S::any_weight(rng));
        let cubic = CompiledCubic::from_parts(S::any_weight(rng), S::any_weight(rng));
        assert_falls::<S, _>(rng, Soft, Soft);
        assert_falls::<S, _>(rng, Hard, Hard);
        assert_falls::<S, _>(rng, Power::<15>, Power::<15>);
        let raw = Quadratic::from_bits(bits(rng) as u32);
        assert_falls::<S, _>(rng, raw, quadratic);
        let raw = Cubic::from_bits([bits(rng) as u32, bits(rng) as u32]);
        assert_falls::<S, _>(rng, raw, cubic);
        assert_distances::<S>(rng);
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

/// Asserts that the figures of a profile, and of cones made with it, are in range.
fn assert_figures<P: Falloff + PartialEq>(rng: &mut Rng, profile: P) {
    for figure in [profile.beam_versine(), profile.field_versine(), profile.integral(rng.f32())] {
        assert!((0.0..=1.0).contains(&figure), "{profile:?}: {figure}");
    }
    for hotspot in [0.0, 0.99 * rng.f32()] {
        let steepness = profile.steepness(hotspot);
        assert!(steepness >= 0.0 && steepness.is_finite(), "{profile:?} {hotspot}: {steepness}");
    }
    let cone = Cone::from_outer(profile, Angle::degrees(1.0 + 179.0 * rng.f32())).expect("a sound angle");
    for flux in [cone.lumens(1000.0), cone.candela(1000.0)] {
        assert!(flux > 0.0 && flux.is_finite(), "{cone:?}: {flux}");
    }
    assert!(Cone::narrowest::<Fx16>(profile).to_degrees().is_finite(), "{profile:?}");
}

#[test]
fn any_bits_make_a_profile_with_figures() {
    let mut rng = Rng::with_seed(0x0b17_5eed);
    for _ in 0..3000 * sweep::effort() {
        let quadratic = Quadratic::from_bits(float_bits(&mut rng));
        assert!((0.0..=2.0).contains(&quadratic.edge_slope()), "{quadratic:?}");
        assert_figures(&mut rng, quadratic);
        let cubic = Cubic::from_bits([float_bits(&mut rng), float_bits(&mut rng)]);
        for slope in [cubic.edge_slope(), cubic.middle_slope()] {
            assert!((0.0..=4.0).contains(&slope), "{cubic:?}");
        }
        assert_figures(&mut rng, cubic);
    }
}
