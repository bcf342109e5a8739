//! Every way of evaluation, over lights and points of any bits: what panics anywhere does not link.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::hint::black_box;

use luminaire::source::{
    CompiledBlend, CompiledCubic, CompiledFitted, FloatFrame, FloatRamp, Frame16, Frame32, Gain16, Gain32,
    I16F16, I18F14, I34F30, Ramp16, Ramp32, U18F14, U34F30,
};
use luminaire::{
    Attenuation, Blend, BlinnPhong, CompiledDirectional, CompiledExposure, CompiledMaterial, CompiledPoint,
    CompiledProjection, CompiledSpot, Cubic, CutOff, DualCone, Edge, Falloff, Fitted, Fx16, Fx32, Gobo, Hard,
    HardRange, Haze, HazyBeam, InverseSquare, Knot, Light, Linear, Lyon, Matte, Phong, Polynomial, Power,
    Profile, RealPower, RealRim, Rgb, Rgb565, Rim, Scalar, Shadow, Smooth, SmoothRange, Soft, Specular,
    SquaredWindow, Surface, Table, Unattenuated, Vec3, ViewBundle, ViewRay, Windowed, clip, encode_srgb,
    encode_srgb_dithered, keep_hue,
};
use luminaire_effects::Format;

luminaire_effects::program!(everything);

fn everything(words: [u64; 64]) {
    of_format::<Format>(&mut Bits { words, next: 0 });
}

/// Bits that the compiler does not know.
struct Bits {
    words: [u64; 64],
    next: u8,
}

impl Bits {
    #[inline(never)]
    fn word(&mut self) -> u64 {
        self.next = self.next.wrapping_add(1);
        self.words[usize::from(self.next % 64)]
    }

    fn vector<T>(&mut self, make: impl Fn(u64) -> T) -> Vec3<T> {
        Vec3::new(make(self.word()), make(self.word()), make(self.word()))
    }

    fn color<T>(&mut self, make: impl Fn(u64) -> T) -> Rgb<T> {
        Rgb::new(make(self.word()), make(self.word()), make(self.word()))
    }
}

/// A format whose values are made of any bits.
trait Raw: Scalar {
    fn scalar(bits: u64) -> Self;
    fn raw_length(bits: u64) -> Self::Length;
    fn unit(bits: u64) -> Self::Unit;
    fn raw_weight(bits: u64) -> Self::Weight;
    fn raw_gain(bits: u64) -> Self::Gain;
    fn light(bits: u64) -> Self::Irradiance;
    fn raw_ramp(bits: &mut Bits) -> Self::Ramp;
    fn raw_frame(bits: &mut Bits) -> Self::Frame;
}

macro_rules! raw {
    ($format:ty, $weight:ident, $gain:ident, $light:ident, $ramp:ident, $frame:ident) => {
        impl Raw for $format {
            fn scalar(bits: u64) -> Self {
                Self::from_bits(bits as _)
            }

            fn raw_length(bits: u64) -> I16F16 {
                I16F16::from_bits(bits as _)
            }

            fn unit(bits: u64) -> Fx32 {
                Fx32::from_bits(bits as _)
            }

            fn raw_weight(bits: u64) -> $weight {
                $weight::from_bits(bits as _)
            }

            fn raw_gain(bits: u64) -> $gain {
                $gain::from_bits([bits as _, (bits >> 32) as _])
            }

            fn light(bits: u64) -> $light {
                $light::from_bits(bits as _)
            }

            fn raw_ramp(bits: &mut Bits) -> $ramp {
                $ramp::from_bits(core::array::from_fn(|_| bits.word() as _))
            }

            fn raw_frame(bits: &mut Bits) -> $frame {
                $frame::from_bits(core::array::from_fn(|_| bits.word() as _))
            }
        }
    };
}

raw!(Fx16, I18F14, Gain16, U18F14, Ramp16, Frame16);
raw!(Fx32, I34F30, Gain32, U34F30, Ramp32, Frame32);

impl Raw for f32 {
    fn scalar(bits: u64) -> f32 {
        f32::from_bits(bits as u32)
    }

    fn raw_length(bits: u64) -> f32 {
        Self::scalar(bits)
    }

    fn unit(bits: u64) -> f32 {
        Self::scalar(bits)
    }

    fn raw_weight(bits: u64) -> f32 {
        Self::scalar(bits)
    }

    fn raw_gain(bits: u64) -> f32 {
        Self::scalar(bits)
    }

    fn light(bits: u64) -> f32 {
        Self::scalar(bits)
    }

    fn raw_ramp(bits: &mut Bits) -> FloatRamp {
        FloatRamp::from_bits(core::array::from_fn(|_| bits.word() as u32))
    }

    fn raw_frame(bits: &mut Bits) -> FloatFrame {
        FloatFrame::from_bits(core::array::from_fn(|_| bits.word() as u32))
    }
}

const PATTERN: [u8; 9] = [255, 0, 1, 254, 127, 128, 3, 200, 40];
const SAMPLES: [u16; 5] = [65_535, 60_000, 31_000, 400, 0];
const KNOTS: [Knot; 2] = [Knot::from_bits(0, 65_535, -65_535), Knot::from_bits(32_768, 32_768, i32::MIN)];

fn of_format<S: Raw>(bits: &mut Bits) {
    let (g, h) = (S::raw_weight(bits.word()), S::raw_weight(bits.word()));
    let (blend, cubic) = (CompiledBlend::from_parts(g), CompiledCubic::from_parts(g, h));
    let any_blend = Blend::from_bits(bits.word() as u32);
    let any_cubic = Cubic::from_bits([bits.word() as u32, bits.word() as u32]);
    falls::<S, _>(bits, Soft, Soft);
    falls::<S, _>(bits, Hard, Hard);
    falls::<S, _>(bits, Linear, Linear);
    falls::<S, _>(bits, CutOff, CutOff);
    falls::<S, _>(bits, Smooth, Smooth);
    falls::<S, _>(bits, any_blend, blend);
    falls::<S, _>(bits, any_cubic, cubic);
    falls::<S, _>(bits, Power::<1>, Power);
    falls::<S, _>(bits, Power::<15>, Power);
    falls::<S, _>(bits, Power::<128>, Power);
    falls::<S, _>(bits, Rim::<4>, Rim);
    let table = Table::new(black_box(SAMPLES.as_slice())).unwrap_or(Table::of(&SAMPLES));
    falls::<S, _>(bits, table, table);
    let knots = Table::of_knots(black_box(&KNOTS));
    falls::<S, _>(bits, knots, knots);
    let exponent = f32::from_bits(bits.word() as u32);
    if let Ok(power) = RealPower::new(exponent) {
        falls::<S, _>(bits, power, power.compile::<S>());
    }
    if let Ok(rim) = RealRim::new(exponent) {
        falls::<S, _>(bits, rim, rim.compile::<S>());
    }
    let edge = if bits.word() == 0 { Edge::Soft } else { Edge::Hard };
    falls::<S, _>(bits, edge, edge);
    falls::<S, _>(bits, Fitted::Blend(any_blend), CompiledFitted::Blend(blend));
    falls::<S, _>(bits, Fitted::Cubic(any_cubic), CompiledFitted::Cubic(cubic));
    let [a, b, c] = core::array::from_fn(|_| S::raw_gain(bits.word()));
    reaches::<S, Unattenuated>(bits, ());
    reaches::<S, InverseSquare>(bits, ());
    reaches::<S, Polynomial>(bits, [a, b, c]);
    reaches::<S, SmoothRange>(bits, [a, b]);
    reaches::<S, Windowed>(bits, a);
    reaches::<S, SquaredWindow>(bits, a);
    reaches::<S, HardRange<InverseSquare>>(bits, (a, ()));
    reaches::<S, HardRange<SmoothRange>>(bits, (a, [b, c]));
    scatters::<InverseSquare>(bits, ());
    let [reach, inverse, squared] = core::array::from_fn(|_| f32::raw_gain(bits.word()));
    scatters::<HardRange<SmoothRange>>(bits, (reach, [inverse, squared]));
    let parallel = CompiledDirectional::<S>::from_parts(bits.vector(S::unit), a, colors(bits));
    black_box(parallel.irradiance(bits.vector(S::scalar)));
    let ramp = S::raw_ramp(bits);
    let exponent = bits.word() as u32;
    shines::<S, Matte>(bits, ());
    shines::<S, Phong>(bits, (ramp, exponent));
    shines::<S, BlinnPhong>(bits, (ramp, exponent));
    shines::<S, DualCone>(bits, (ramp, exponent));
    shines::<S, Lyon<Phong, 0>>(bits, ramp);
    shines::<S, Lyon<BlinnPhong, 4>>(bits, ramp);
    projects::<S>(bits);
    shows::<S>(bits);
}

fn colors<S: Raw>(bits: &mut Bits) -> [Rgb<S>; 2] {
    [bits.color(S::scalar), bits.color(S::scalar)]
}

fn surface<S: Raw>(bits: &mut Bits) -> Surface<S> {
    let (point, normal) = (bits.vector(S::raw_length), bits.vector(S::scalar));
    if bits.word() == 0 {
        Surface::seen_from(bits.vector(S::raw_length), point, normal)
    } else {
        Surface { point, normal, view: bits.vector(S::unit) }
    }
}

fn spot<S: Raw, P: Profile, A: Attenuation>(
    bits: &mut Bits,
    profile: P,
    curve: P::Compiled<S>,
    attenuation: A::Constants<S>,
) -> CompiledSpot<S, P, A> {
    let falloff = Falloff::from_parts(S::raw_ramp(bits), profile, curve);
    let (position, axis) = (bits.vector(S::raw_length), bits.vector(S::unit));
    let (outside, intensity) = (S::scalar(bits.word()), S::raw_gain(bits.word()));
    CompiledSpot::from_parts(position, axis, falloff, outside, attenuation, intensity, bits.word() as u32, colors(bits))
}

/// A profile, on its own and in a light.
#[inline(never)]
fn falls<S: Raw, P: Profile>(bits: &mut Bits, profile: P, curve: P::Compiled<S>) {
    let light = spot::<S, P, InverseSquare>(bits, profile, curve, ());
    let Surface { point, normal, .. } = surface::<S>(bits);
    black_box(light.falloff(point));
    black_box(light.irradiance(point, normal));
    black_box(light.irradiance_unskipped(point, normal));
}

/// A distance model, in both kinds of light that have one.
#[inline(never)]
fn reaches<S: Raw, A: Attenuation>(bits: &mut Bits, attenuation: A::Constants<S>) {
    let spot = spot::<S, Soft, A>(bits, Soft, Soft, attenuation);
    let position = bits.vector(S::raw_length);
    let point =
        CompiledPoint::<S, A>::from_parts(position, attenuation, S::raw_gain(bits.word()), bits.word() as u32, colors(bits));
    let Surface { point: place, normal, .. } = surface::<S>(bits);
    black_box(spot.irradiance(place, normal));
    black_box(spot.irradiance_unskipped(place, normal));
    black_box(point.irradiance(place, normal));
    black_box(point.irradiance_unskipped(place, normal));
}

/// A beam in haze, which is f32 in every format.
#[inline(never)]
fn scatters<A: Attenuation>(bits: &mut Bits, attenuation: A::Constants<f32>) {
    let light = spot::<f32, Soft, A>(bits, Soft, Soft, attenuation);
    if let Ok(haze) = Haze::new(f32::scalar(bits.word())) {
        black_box(light.in_haze(&haze));
    }
    let falloff = Falloff::from_parts(f32::raw_ramp(bits), Soft, Soft);
    let (position, axis) = (bits.vector(f32::raw_length), bits.vector(f32::unit));
    let [gain, inner, outer, radius, reach, length, versine] =
        core::array::from_fn(|_| f32::scalar(bits.word()));
    let beam = HazyBeam::<Soft, A>::from_parts(
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
    black_box(beam.air_light(&view));
    black_box(beam.air_light_through(&view, 4, |point| point.x));
    black_box(beam.can_meet(&ViewBundle { eye, direction, versine, length }));
    black_box(ViewRay::between(eye, direction));
}

/// A highlight, under every kind of light.
#[inline(never)]
fn shines<S: Raw, H: Specular>(bits: &mut Bits, highlight: H::Constants<S>) {
    let emissive = bits.color(S::light);
    let [ambient, diffuse] = colors(bits);
    let material =
        CompiledMaterial::<S, H>::from_parts(ambient, diffuse, emissive, bits.color(S::scalar), highlight);
    black_box(material.glow(bits.color(S::light)));
    let spot = spot::<S, Soft, InverseSquare>(bits, Soft, Soft, ());
    reflects(bits, &material, &spot);
    let (place, intensity) = (bits.vector(S::raw_length), S::raw_gain(bits.word()));
    let point = CompiledPoint::<S>::from_parts(place, (), intensity, bits.word() as u32, colors(bits));
    reflects(bits, &material, &point);
    let parallel = CompiledDirectional::<S>::from_parts(bits.vector(S::unit), intensity, colors(bits));
    reflects(bits, &material, &parallel);
}

fn reflects<S: Raw, H: Specular, L: Light<S>>(bits: &mut Bits, material: &CompiledMaterial<S, H>, light: &L) {
    let surface = surface::<S>(bits);
    black_box(material.reflect(&surface, light));
    black_box(material.reflect_unskipped(&surface, light));
}

/// A pattern of any size on any square.
#[inline(never)]
fn projects<S: Raw>(bits: &mut Bits) {
    let position = bits.vector(S::raw_length);
    let square = CompiledProjection::<S>::from_parts(position, S::raw_frame(bits));
    black_box(square.place(bits.vector(S::raw_length)));
    let pattern = Gobo::new(bits.word() as usize, black_box(PATTERN.as_slice())).unwrap_or(Gobo::of(&[[9]]));
    let light = S::light(bits.word());
    black_box(pattern.on(square).filter(light, bits.vector(S::raw_length)));
    let depths: [S::Length; 9] = core::array::from_fn(|_| S::raw_length(bits.word()));
    let shadow = Shadow::from_parts(square, bits.word() as u32, black_box(depths.as_slice()));
    black_box(shadow.visibility(bits.vector(S::raw_length)));
}

/// From light to the codes of a display.
#[inline(never)]
fn shows<S: Raw>(bits: &mut Bits) {
    let (light, other) = (bits.color(S::light), bits.color(S::light));
    let exposure = CompiledExposure::<S>::from_parts(S::raw_gain(bits.word()));
    let sum = exposure.expose(light.plus::<S>(other).filtered::<S>(bits.color(S::scalar)));
    black_box(clip::<S>(sum));
    black_box(keep_hue::<S>(sum));
    let color = bits.color(S::scalar);
    black_box(color.map(encode_srgb));
    let (x, y) = (bits.word() as u32, bits.word() as u32);
    black_box(color.map(|channel| encode_srgb_dithered(channel, x, y)));
    black_box(Rgb565::from_linear_dithered(color, x, y));
    let pixel = Rgb565::from_linear(color);
    black_box(Rgb565::from_codes(pixel.to_codes()));
}
