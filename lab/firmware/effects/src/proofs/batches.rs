//! Slices of points, each quantity in a slice of its own: what panics anywhere does not link.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::hint::black_box;

use luminaire::{
    Rgb, Scalar, Vec3,
    attenuation::{CutAt, InverseSquare, Polynomial},
    falloff::{Falloff, Power, Soft},
    light::CompiledCone,
};
use luminaire_effects::Format;
use luminaire_effects::raw::{Bits, Raw, each};

luminaire_effects::program!(batches);

/// As much memory as there is for each quantity. How much of it a slice has, the compiler does not
/// know.
const MOST: usize = 4;

fn batches(words: [u64; 64]) {
    of_format::<Format>(&mut Bits::new(words));
}

fn of_format<S: Raw>(bits: &mut Bits) {
    shine::<S, _>(bits, Soft);
    shine::<S, _>(bits, Power::<15>);
    shine::<S, _>(bits, Bits::any_table());
    // All the other profiles, by a branch.
    let matched = bits.any_profile();
    shine::<S, _>(bits, matched);
    let gains = [S::raw_gain(bits.word()), S::raw_gain(bits.word()), S::raw_gain(bits.word())];
    let point = bits.any_point::<S, InverseSquare>(());
    let limited = bits.any_point::<S, CutAt<Polynomial>>((gains[0], gains));
    let sites = Sites::<S>::new(bits);
    let (points, normals) = sites.slices();
    let mut sums = Sums::<S>::default();
    point.irradiance_each(points, normals, black_box(&mut sums.red[..]));
    point.add_each(points, normals, slices(&mut sums));
    limited.irradiance_each(points, normals, black_box(&mut sums.red[..]));
    limited.add_each(points, normals, slices(&mut sums));
}

/// Points and their normals.
struct Sites<S: Raw> {
    points: Vec3<[S::Length; MOST]>,
    normals: Vec3<[S; MOST]>,
}

/// Sums of light.
type Sums<S> = Rgb<[<S as Scalar>::Irradiance; MOST]>;

impl<S: Raw> Sites<S> {
    fn new(bits: &mut Bits) -> Self {
        Self { points: bits.columns(S::raw_length), normals: bits.columns(S::scalar) }
    }

    fn slices(&self) -> (Vec3<&[S::Length]>, Vec3<&[S]>) {
        (
            each(&self.points).map(|column| black_box(&column[..])),
            each(&self.normals).map(|column| black_box(&column[..])),
        )
    }
}

fn slices<T>(sums: &mut Rgb<[T; MOST]>) -> Rgb<&mut [T]> {
    let Rgb { red, green, blue } = sums;
    Rgb::new(black_box(&mut red[..]), black_box(&mut green[..]), black_box(&mut blue[..]))
}

/// A spotlight of a profile, and its falloff.
#[inline(never)]
fn shine<S: Raw, P: Falloff>(bits: &mut Bits, profile: P) {
    let light = bits.any_spot::<S, P, InverseSquare>(profile, profile.compile::<S>(), ());
    let sites = Sites::<S>::new(bits);
    let (points, normals) = sites.slices();
    let mut sums = Sums::<S>::default();
    light.irradiance_each(points, normals, black_box(&mut sums.red[..]));
    light.add_each(points, normals, slices(&mut sums));
    let falloff = CompiledCone::<S, P>::from_parts(S::raw_ramp(bits), profile, profile.compile::<S>());
    let versines = [falloff.versine(bits.float()), falloff.versine(bits.float())];
    let mut intensities = bits.column::<S, MOST>(S::scalar);
    falloff.at_each(black_box(&versines[..]), black_box(&mut intensities[..]));
}
