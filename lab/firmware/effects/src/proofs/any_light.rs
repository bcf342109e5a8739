//! Lights of any kind, at a point and at many, and their beams in haze: what panics anywhere does
//! not link.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::hint::black_box;

use luminaire::{
    Scalar, Vec3,
    attenuation::{AnyAttenuation, Attenuation},
    dynamic::{CompiledAnyLight, SurfacePoints},
    falloff::{AnyFalloff, Falloff},
    haze::{BeamScattering, Haze, ViewRays},
    light::{CompiledDirectionalLight, LightModel, SurfacePoint},
    specular::{DifferenceForm, NoSpecular, Phong, SpecularLobe},
};
use luminaire_effects::Format;
use luminaire_effects::raw::{Bits, Raw, each};

luminaire_effects::program!(any_light);

/// As many points as a renderer may take at once.
const LANES: usize = 4;

fn any_light(words: [u64; 64]) {
    of_format::<Format>(&mut Bits::new(words));
}

fn of_format<S: Raw>(bits: &mut Bits) {
    let light = light::<S>(bits);
    let lobe = (S::raw_ramp(bits), bits.word() as u32);
    arrives_each::<S, DifferenceForm<Phong, 3>>(bits, &light, &lobe.0);
    arrives::<S, NoSpecular>(bits, &light, &());
    arrives::<S, Phong>(bits, &light, &lobe);
    if S::NAME == f32::NAME {
        let (haze, light) = (Haze::new(bits.float()), self::light::<f32>(bits));
        if let Ok(haze) = haze
            && let Some(beam) = CompiledAnyLight::in_haze(&light, &haze)
        {
            scatters(bits, &beam);
        }
    }
}

/// A light of any kind, profile and distance model; its profile and its curve need not be of one
/// kind.
#[inline(never)]
fn light<S: Raw>(bits: &mut Bits) -> CompiledAnyLight<S> {
    let attenuation = bits.any_distance().constants::<S>();
    match bits.choice(3) {
        0 => {
            let (direction, intensity) = (bits.vector(S::unit), S::raw_gain(bits.word()));
            CompiledAnyLight::Directional(CompiledDirectionalLight::from_parts(
                direction,
                intensity,
                bits.colors(),
            ))
        }
        1 => CompiledAnyLight::Point(bits.any_point(attenuation)),
        _ => {
            let (profile, curve) = (bits.any_profile(), bits.any_profile().compile::<S>());
            CompiledAnyLight::Spot(bits.any_spot(profile, curve, attenuation))
        }
    }
}

/// A kind of highlight at many points. One is enough: the loops have nothing of their own for
/// another, for each profile and distance model, and without highlights they have less. What each
/// does at a point is in the program `everything`.
#[inline(never)]
fn arrives_each<S: Raw, H: SpecularLobe>(
    bits: &mut Bits,
    light: &CompiledAnyLight<S>,
    highlight: &H::Constants<S>,
) {
    let (points, normals, views) =
        (bits.columns(S::raw_length), bits.columns(S::scalar), bits.columns(S::unit));
    let surfaces =
        SurfacePoints::<S, LANES> { point: each(&points), normal: each(&normals), view: each(&views) };
    let mut arrivals = Default::default();
    light.evaluate_each::<H, LANES>(&surfaces, highlight, &mut arrivals);
    black_box(arrivals);
    black_box(SurfacePoints::at(&surfaces, bits.word() as usize));
}

/// A kind of highlight at a point, under a light of any kind.
#[inline(never)]
fn arrives<S: Raw, H: SpecularLobe>(
    bits: &mut Bits,
    light: &CompiledAnyLight<S>,
    highlight: &H::Constants<S>,
) {
    let (point, normal) = (bits.vector(S::raw_length), bits.vector(S::scalar));
    let surface = SurfacePoint { point, normal, view: bits.vector(S::unit) };
    let skips = bits.choice(2) == 0;
    black_box(light.evaluate::<H>(&surface, highlight, skips));
    black_box(light.colors());
}

/// A beam in haze, for one ray and for many.
#[inline(never)]
fn scatters(bits: &mut Bits, beam: &BeamScattering<AnyFalloff, AnyAttenuation>) {
    let rays = ViewRays::<LANES> {
        eye: bits.vector(f32::raw_length),
        direction: bits.columns(f32::unit),
        length: bits.column(f32::raw_length),
    };
    let mut lights = [0.0; LANES];
    beam.in_scattering_each(&rays, &mut lights);
    black_box(lights);
    let mut filter = |places: &Vec3<[f32; LANES]>, lights: &mut [f32; LANES]| {
        lights.iter_mut().zip(black_box(places.x)).for_each(|(light, x)| *light *= x);
    };
    beam.in_scattering_through_each(&rays, &mut filter, &mut lights);
    black_box(lights);
    let ray = ViewRays::at(&rays, bits.word() as usize);
    black_box(beam.in_scattering(&ray));
    black_box(beam.in_scattering_through(&ray, 4, |point| point.x));
}
