//! Every evaluation, over lights and points of any bits: if any can panic, the program does not
//! link.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::hint::black_box;

use luminaire::{
    Error, Rgb, Scalar,
    codegen::{CompiledCubic, CompiledFittedFalloff, CompiledQuadratic},
    display::{CompiledExposure, Rgb565, clip, compress_keep_hue, encode_srgb, encode_srgb_dithered},
    haze::{BeamScattering, Haze, RayBundle, ViewRay},
    light::{
        CompiledCone, CompiledDirectionalLight, CompiledMaterial, CompiledPointLight, CompiledSpotLight,
        LightModel, SurfacePoint,
    },
    models::SAMPLES,
    projector::{CompiledGobo, CompiledProjection, Gobo, Shadow},
};
#[allow(clippy::wildcard_imports, reason = "the types of the lists")]
use luminaire::{attenuation::*, falloff::*, specular::*};
use luminaire_effects::Format;
use luminaire_effects::raw::{Bits, Raw};

luminaire_effects::program!(everything);

fn everything(words: [u64; 64]) {
    of_format::<Format>(&mut Bits::new(words));
}

const PATTERN: [u8; 9] = [255, 0, 1, 254, 127, 128, 3, 200, 40];

fn of_format<S: Raw>(bits: &mut Bits) {
    let (g, h) = (S::raw_weight(bits.word()), S::raw_weight(bits.word()));
    let (quadratic, cubic) = (CompiledQuadratic::from_parts(g), CompiledCubic::from_parts(g, h));
    let any_quadratic = Quadratic::from_bits(bits.word() as u32);
    let any_cubic = Cubic::from_bits([bits.word() as u32, bits.word() as u32]);
    falls::<S, _>(bits, any_quadratic, quadratic);
    falls::<S, _>(bits, any_cubic, cubic);
    falls::<S, _>(bits, Power::<1>, Power);
    falls::<S, _>(bits, Power::<15>, Power);
    falls::<S, _>(bits, Power::<128>, Power);
    for table in [Bits::any_table(), Bits::any_knots()] {
        falls::<S, _>(bits, table, table);
    }
    listed::<S>(bits);
    let edge = if bits.word() == 0 { SoftOrHard::Soft } else { SoftOrHard::Hard };
    falls::<S, _>(bits, edge, edge);
    falls::<S, _>(bits, FittedFalloff::Quadratic(any_quadratic), CompiledFittedFalloff::Quadratic(quadratic));
    falls::<S, _>(bits, FittedFalloff::Cubic(any_cubic), CompiledFittedFalloff::Cubic(cubic));
    let [a, b, c] = core::array::from_fn(|_| S::raw_gain(bits.word()));
    reaches::<S, NoAttenuation>(bits, ());
    reaches::<S, CutAt<SmoothRange>>(bits, (a, [b, c]));
    // Haze is f32 in every format.
    if S::NAME == f32::NAME {
        scatters::<InverseSquare>(bits, ());
        let [reach, inverse, squared] = core::array::from_fn(|_| f32::raw_gain(bits.word()));
        scatters::<CutAt<SmoothRange>>(bits, (reach, [inverse, squared]));
    }
    let parallel = CompiledDirectionalLight::<S>::from_parts(bits.vector(S::unit), a, bits.colors());
    black_box(CompiledDirectionalLight::irradiance(&parallel, bits.vector(S::scalar)));
    let ramp = S::raw_ramp(bits);
    shines::<S, NoSpecular>(bits, ());
    shines::<S, DifferenceForm<Phong, 0>>(bits, ramp);
    shines::<S, DifferenceForm<BlinnPhong, 4>>(bits, ramp);
    projects::<S>(bits);
    shows::<S>(bits);
}

/// The models of the lists, of constants that the compiler does not know.
fn listed<S: Raw>(bits: &mut Bits) {
    macro_rules! falloffs {
        ($($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr, $truth:expr;)*) => {
            $(
                let sample: Result<$type, Error> = $sample;
                if let Ok(falloff) = sample {
                    falls::<S, $type>(bits, black_box(falloff), black_box(falloff.compile::<S>()));
                }
            )*
        };
    }
    luminaire::constant_falloffs!(falloffs);
    macro_rules! attenuations {
        ($($(#[$doc:meta])* $variant:ident($run_time:ty) = any $any:expr
           $(, $(#[$its_doc:meta])* $type:ty = $name:literal, $value:expr)*;)*) => {
            $($(
                let value: Result<$type, Error> = $value;
                if let Ok(attenuation) = value {
                    reaches::<S, $type>(bits, black_box(attenuation.constants::<S>()));
                }
            )*)*
        };
    }
    luminaire::attenuations!(attenuations);
    macro_rules! lobes {
        ($($(#[$doc:meta])* $type:ty = $name:literal, $value:expr;)*) => {
            $(
                let constants = <$type as SpecularLobe>::constants::<S>(bits.integer());
                shines::<S, $type>(bits, constants);
            )*
        };
    }
    luminaire::lobes!(lobes);
}

fn surface<S: Raw>(bits: &mut Bits) -> SurfacePoint<S> {
    let (point, normal) = (bits.vector(S::raw_length), bits.vector(S::scalar));
    if bits.word() == 0 {
        SurfacePoint::seen_from(bits.vector(S::raw_length), point, normal)
    } else {
        SurfacePoint { point, normal, view: bits.vector(S::unit) }
    }
}

/// A profile, on its own and in a light.
#[inline(never)]
fn falls<S: Raw, P: Falloff>(bits: &mut Bits, profile: P, curve: P::Compiled<S>) {
    let light = bits.any_spot::<S, P, InverseSquare>(profile, curve, ());
    let SurfacePoint { point, normal, .. } = surface::<S>(bits);
    black_box(light.falloff(point));
    black_box(CompiledSpotLight::irradiance(&light, point, normal));
    black_box(CompiledSpotLight::irradiance_unskipped(&light, point, normal));
}

/// A distance model, in both kinds of light that have one.
#[inline(never)]
fn reaches<S: Raw, A: Attenuation>(bits: &mut Bits, attenuation: A::Constants<S>) {
    let spot = bits.any_spot::<S, Soft, A>(Soft, Soft, attenuation);
    let point = bits.any_point::<S, A>(attenuation);
    let SurfacePoint { point: place, normal, .. } = surface::<S>(bits);
    black_box(CompiledSpotLight::irradiance(&spot, place, normal));
    black_box(CompiledSpotLight::irradiance_unskipped(&spot, place, normal));
    black_box(CompiledPointLight::irradiance(&point, place, normal));
    black_box(CompiledPointLight::irradiance_unskipped(&point, place, normal));
}

/// A beam in haze.
#[inline(never)]
fn scatters<A: Attenuation>(bits: &mut Bits, attenuation: A::Constants<f32>) {
    let light = bits.any_spot::<f32, Soft, A>(Soft, Soft, attenuation);
    if let Ok(haze) = Haze::new(f32::scalar(bits.word())) {
        black_box(CompiledSpotLight::in_haze(&light, &haze));
    }
    let falloff = CompiledCone::from_parts(f32::raw_ramp(bits), Soft, Soft);
    let (position, axis) = (bits.vector(f32::raw_length), bits.vector(f32::unit));
    let [gain, inner, outer, radius, reach, length, versine] =
        core::array::from_fn(|_| f32::scalar(bits.word()));
    let beam = BeamScattering::<Soft, A>::from_parts(
        position,
        axis,
        falloff,
        attenuation,
        gain,
        [inner, outer],
        [radius, reach],
    );
    let (eye, direction) = (bits.vector(f32::raw_length), bits.vector(f32::unit));
    let view = ViewRay { eye, direction, length };
    black_box(beam.in_scattering(&view));
    black_box(beam.in_scattering_through(&view, 4, |point| point.x));
    black_box(beam.can_meet(&RayBundle { eye, direction, versine, length }));
    black_box(ViewRay::between(eye, direction));
}

/// A highlight, under every kind of light.
#[inline(never)]
fn shines<S: Raw, H: SpecularLobe>(bits: &mut Bits, highlight: H::Constants<S>) {
    let emissive = bits.color(S::light);
    let [ambient, diffuse] = bits.colors::<S>();
    let material =
        CompiledMaterial::<S, H>::from_parts(ambient, diffuse, emissive, bits.color(S::scalar), highlight);
    black_box(material.glow(bits.color(S::light)));
    let spot = bits.any_spot::<S, Soft, InverseSquare>(Soft, Soft, ());
    reflects(bits, &material, &spot);
    let point = bits.any_point::<S, InverseSquare>(());
    reflects(bits, &material, &point);
    let (direction, intensity) = (bits.vector(S::unit), S::raw_gain(bits.word()));
    let parallel = CompiledDirectionalLight::<S>::from_parts(direction, intensity, bits.colors());
    reflects(bits, &material, &parallel);
}

fn reflects<S: Raw, H: SpecularLobe, L: LightModel<S>>(
    bits: &mut Bits,
    material: &CompiledMaterial<S, H>,
    light: &L,
) {
    let surface = surface::<S>(bits);
    black_box(material.reflect(&surface, light));
    black_box(material.reflect_unskipped(&surface, light));
}

/// A pattern of any size on any square.
#[inline(never)]
fn projects<S: Raw>(bits: &mut Bits) {
    let position = bits.vector(S::raw_length);
    let square = CompiledProjection::<S>::from_parts(position, S::raw_frame(bits));
    let place = CompiledProjection::place(&square, bits.vector(S::raw_length));
    black_box(place.is_inside());
    let pattern = Gobo::new(bits.word() as usize, black_box(PATTERN.as_slice())).unwrap_or(Gobo::of(&[9]));
    let light = S::light(bits.word());
    let gobo = pattern.on(square);
    black_box(CompiledGobo::filter(&gobo, light, bits.vector(S::raw_length)));
    black_box(CompiledGobo::at(&gobo, bits.vector(S::raw_length)));
    black_box((Gobo::transmission(pattern, &place), Gobo::side(pattern)));
    let depths: [S::Length; 9] = core::array::from_fn(|_| S::raw_length(bits.word()));
    let shadow = Shadow::from_parts(square, bits.word() as u32, black_box(depths.as_slice()));
    black_box(shadow.visibility(bits.vector(S::raw_length)));
    black_box((Shadow::at(&shadow, &place), Shadow::side(&shadow)));
}

/// From light to the codes of a display.
#[inline(never)]
fn shows<S: Raw>(bits: &mut Bits) {
    let (light, other) = (bits.color(S::light), bits.color(S::light));
    let exposure = CompiledExposure::<S>::from_parts(S::raw_gain(bits.word()));
    let sum = Rgb::plus::<S>(Rgb::lit(S::light(bits.word()), bits.color(S::scalar)), light);
    let sum = Rgb::plus::<S>(sum, other).filtered::<S>(bits.color(S::scalar));
    let sum = CompiledExposure::expose(&exposure, sum);
    black_box(clip::<S>(sum));
    black_box(compress_keep_hue::<S>(sum));
    let color = bits.color(S::scalar);
    black_box(color.map(encode_srgb));
    let (x, y) = (bits.word() as u32, bits.word() as u32);
    black_box(color.map(|channel| encode_srgb_dithered(channel, x, y)));
    black_box(Rgb565::from_linear_dithered(color, x, y));
    let pixel = Rgb565::from_linear(color);
    black_box(Rgb565::from_codes(pixel.to_codes()));
}
