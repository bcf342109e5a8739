//! Every operation of the seam between the kernel and a number format, on any bits: what panics
//! anywhere does not link.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::array::from_fn;
use core::hint::black_box;

use luminaire::codegen::{CompiledCubic, CompiledQuadratic};
use luminaire::{
    Rgb, Vec3,
    attenuation::{AnyAttenuation, Attenuation, InverseSquare},
    dynamic::{Effect, Effects},
    falloff::{AnyFalloff, Cubic, Curve, Falloff, Knot, Soft},
    light::{CompiledCone, CompiledSpotLight, LightModel, SurfacePoint},
    number::{Fraction, Gain, Offset, Ray, Rise, Share, Slopes},
    specular::{BlinnPhong, DifferenceForm, DualConeLobe, Highlight, NoSpecular, Phong, SpecularLobe},
};
use luminaire_effects::Format;
use luminaire_effects::raw::{Bits, Raw};

luminaire_effects::program!(seam);

fn seam(words: [u64; 64]) {
    of_format::<Format>(&mut Bits::new(words));
}

fn of_format<S: Raw>(bits: &mut Bits) {
    converts::<S>(bits);
    multiplies::<S>(bits);
    points::<S>(bits);
    shows::<S>(bits);
    falls::<S>(bits);
    glitters::<S, NoSpecular>(bits);
    glitters::<S, Phong>(bits);
    glitters::<S, BlinnPhong>(bits);
    glitters::<S, DualConeLobe>(bits);
    glitters::<S, DifferenceForm<Phong, 3>>(bits);
    keeps::<S>(bits);
}

/// From floats to the format and back.
#[inline(never)]
fn converts<S: Raw>(bits: &mut Bits) {
    black_box(S::to_f32(S::from_f32(bits.float())));
    black_box((S::length(bits.float()), S::weight(bits.float()), S::gain(bits.float())));
    let [way, unit] = from_fn(|_| bits.vector(f32::scalar));
    black_box((S::axis(unit), S::aim(way, unit)));
    let [inner, outer, limit] = from_fn(|_| bits.float());
    black_box((S::ramp(inner, outer, limit), S::fine_ramp(inner, outer, limit)));
    let edge = Slopes { angle: bits.float(), fraction: bits.float() };
    black_box((S::rounding(&edge), S::coarse_error(&edge, outer, limit)));
    black_box(S::fine_below(bits.float(), bits.float(), bits.choice(2) == 0));
    let vectors = from_fn(|_| bits.vector(f32::scalar));
    black_box(S::frame(vectors, bits.float()));
    black_box((S::part(bits.word() as u32), S::weighted_byte(bits.word() as u32)));
    black_box(S::versine(S::raw_ramp(bits), bits.float()));
}

/// Scalars, gains and directions.
#[inline(never)]
fn multiplies<S: Raw>(bits: &mut Bits) {
    let [a, b] = from_fn(|_| S::scalar(bits.word()));
    black_box((S::times(a, b), S::minus(a, b), S::smooth(a)));
    let [a, b] = from_fn(|_| S::raw_gain(bits.word()));
    black_box((Gain::by(a, b), Gain::plus(a, b), Gain::inverse_capped(a), Gain::fraction(b)));
    let [a, b] = from_fn(|_| bits.vector(S::unit));
    let normal = bits.vector(S::scalar);
    black_box((S::normal_unit(normal), S::mirror(a, normal), S::direction_between(a, b)));
    black_box(S::incidence(a, normal));
    let ramp = S::raw_ramp(bits);
    let versine = S::versine_between(a, b, ramp);
    black_box(S::power(versine, bits.integer()));
    if let Rise::Fine(t) = S::rise(ramp, versine) {
        bends(bits, t, t);
    }
    black_box(Vec3::dot(bits.vector(f32::scalar), bits.vector(f32::scalar)));
}

/// The offset from a light to a point.
#[inline(never)]
fn points<S: Raw>(bits: &mut Bits) {
    let [light, point] = from_fn(|_| bits.vector(S::raw_length));
    let (axis, normal) = (bits.vector(S::unit), bits.vector(S::scalar));
    black_box(S::place(&S::raw_frame(bits), light, point));
    let offset = S::offset(light, point);
    let facing = Offset::facing(&offset, normal);
    black_box(
        <S::Offset as Offset<S>>::faces_away(facing) | <S::Offset as Offset<S>>::faces_far_away(facing),
    );
    black_box(Offset::is_outside(&offset, axis, S::scalar(bits.word())));
    black_box(Offset::squared_distance(&offset));
    black_box(Offset::is_near(&offset, bits.integer()));
    black_box(Offset::reciprocal(&offset));
    let reciprocal = bits.float();
    let ray = if bits.choice(2) == 0 { Offset::ray(&offset) } else { Offset::ray_of(&offset, reciprocal) };
    goes(bits, &offset, &ray);
    goes(bits, &offset, &Offset::fine_ray(&offset));
}

/// Calls the operations of a ray, coarse or fine, and those of a light with any profile and
/// attenuation at that point.
#[inline(never)]
fn goes<S: Raw, R: Ray<S>>(bits: &mut Bits, offset: &S::Offset, ray: &R) {
    let (axis, normal, ramp) = (bits.vector(S::unit), bits.vector(S::scalar), S::raw_ramp(bits));
    black_box((Ray::distance(ray), Ray::direction(ray), Ray::versine(ray, axis, ramp)));
    let cosine = Ray::cosine(ray, Offset::facing(offset, normal), normal);
    bends(bits, Ray::rise(ray, axis, ramp), cosine);
    let gain = S::raw_gain(bits.word());
    let [share, other] = [Ray::near(ray, gain), Ray::squared_near(ray, offset, gain)];
    shares(bits, share, other);
    black_box(Ray::expose(ray, share, gain));
    let curve = Falloff::compile::<S>(bits.any_profile());
    let falloff = CompiledCone::<S, AnyFalloff>::from_parts(ramp, bits.any_profile(), curve);
    black_box(CompiledCone::toward(&falloff, ray, axis));
    let constants = Attenuation::constants::<S>(bits.any_distance());
    black_box(<AnyAttenuation as Attenuation>::expose::<S, R>(&constants, offset, ray, other, gain));
}

/// Shares of a light.
fn shares<S: Raw, T: Share<S>>(bits: &mut Bits, share: T, other: T) {
    let of_scalar = <T as Share<S>>::of_scalar(S::scalar(bits.word()));
    black_box((Share::rounded(of_scalar), Share::is_all(of_scalar), Share::rest(share)));
    black_box((Share::share_of(share, other), Share::smoothed(share)));
    black_box(Share::give(share, S::raw_gain(bits.word())));
}

/// Fractions, and the curves of profiles.
#[inline(never)]
fn bends<S: Raw, F: Fraction<S>>(bits: &mut Bits, t: F, other: F) {
    black_box((Fraction::complement(t), Fraction::fine_product(t, other), Fraction::product(t, other)));
    let value = <F::Value as Share<S>>::of_scalar(S::scalar(bits.word()));
    black_box((Fraction::scalar(t), Fraction::of(t, value), <F as Fraction<S>>::lack(value)));
    black_box(<F as Fraction<S>>::mixed(value, t.scalar(), S::scalar(bits.word())));
    black_box((Fraction::step(t), Fraction::smooth(t)));
    let (g, h) = (S::raw_weight(bits.word()), S::raw_weight(bits.word()));
    black_box((Fraction::quadratic(t, g), Fraction::cubic(t, g, h)));
    let samples: [u16; 4] = bits.column(|bits| bits as u16);
    black_box(Fraction::sample(t, black_box(&samples[..])));
    let knots: [Knot; 4] =
        bits.column(|bits| Knot::from_bits(bits as u16, (bits >> 16) as u16, (bits >> 32) as i32));
    black_box(Fraction::along(t, black_box(&knots[..])));
    black_box(Curve::<S>::intensity(CompiledQuadratic::from_parts(g), t));
    black_box(Curve::<S>::intensity(CompiledCubic::from_parts(g, h), t));
    let curve = Falloff::compile::<S>(bits.any_profile());
    black_box(Curve::<S>::intensity(curve, t));
}

/// Light.
#[inline(never)]
fn shows<S: Raw>(bits: &mut Bits) {
    let [a, b] = from_fn(|_| S::light(bits.word()));
    let [color, part] = from_fn(|_| S::scalar(bits.word()));
    let gain = S::raw_gain(bits.word());
    black_box((S::expose(part, gain), S::filter(a, color), S::add_light(a, b), S::amplify(a, gain)));
    black_box((S::light_to_f32(a), S::light_to_gain(b), S::clip(a), S::is_clipped(part, b)));
    black_box(S::word(color));
}

/// A distance model and a cone that are chosen at run time.
#[inline(never)]
fn falls<S: Raw>(bits: &mut Bits) {
    let model = bits.any_distance();
    black_box((AnyAttenuation::range(&model), Attenuation::grows(&model)));
    let constants = Attenuation::constants::<S>(model);
    let [light, point] = from_fn(|_| bits.vector(S::raw_length));
    let offset = S::offset(light, point);
    black_box(<AnyAttenuation as Attenuation>::is_inverse_square::<S>(&constants));
    black_box(<AnyAttenuation as Attenuation>::is_beyond::<S>(&constants, &offset));
    let profile = bits.any_profile();
    let falloff = CompiledCone::<S, AnyFalloff>::from_parts(S::raw_ramp(bits), profile, profile.compile());
    black_box(CompiledCone::at(&falloff, CompiledCone::versine(&falloff, bits.float())));
    black_box(CompiledCone::at(
        &CompiledCone::with_profile(&falloff, Soft),
        CompiledCone::versine(&falloff, bits.float()),
    ));
}

/// A kind of highlight by itself.
#[inline(never)]
fn glitters<S: Raw, H: SpecularLobe>(bits: &mut Bits) {
    let constants = <H as SpecularLobe>::constants::<S>(bits.word() as u32);
    black_box(<H as SpecularLobe>::end(bits.word() as u32));
    let [incoming, view] = from_fn(|_| bits.vector(S::unit));
    let normal = bits.vector(S::scalar);
    black_box(<H as SpecularLobe>::lobe::<S>(&constants, incoming, normal, view));
    black_box(<BlinnPhong as Highlight>::directions::<S>(incoming, normal, view));
}

/// What gives back a part of what was made, and what makes one of another.
#[inline(never)]
fn keeps<S: Raw>(bits: &mut Bits) {
    let spot = bits.any_spot::<S, Soft, InverseSquare>(Soft, Soft, ());
    black_box((CompiledSpotLight::profile(&spot), CompiledSpotLight::with_profile(&spot, Soft)));
    let point = bits.any_point::<S, InverseSquare>(());
    black_box(point.colors());
    let position = bits.vector(S::raw_length);
    black_box(SurfacePoint::<S>::matte(position, bits.vector(S::scalar)));
    let colors = Rgb::zip(bits.color(S::scalar), bits.color(S::scalar), |a, b| a.minus(b));
    black_box(Rgb::map(colors, S::to_f32));
    let lengths = Vec3::zip(position, bits.vector(S::raw_length), |a, b| if a < b { a } else { b });
    black_box(Vec3::map(lengths, |length| length));
    black_box(Cubic::coefficients(bits.any_cubic()));
    let effects = Effects::with(Effects::NONE, Effect::Gobo);
    black_box(Effects::has(Effects::union(effects, Effects::ALL), black_box(Effect::Soft)));
}
