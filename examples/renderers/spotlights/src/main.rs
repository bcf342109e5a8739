//! Runs both spotlights over the same points between the markers of the instruction counter, and prints
//! a checksum of the results of each.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::array;

use embedded_graphics_core::pixelcolor::{IntoStorage as _, Rgb565};
use luminaire::{Fx16, Length, Vec3};
use luminaire_firmware::{COUNT, begin_lines, pass, report};
use luminaire_kernels::scene::{Population, Site, Sites};
use luminaire_spotlights::{cone, cone16, cone32, ours, pixel, theirs};
use nalgebra::Point3;

luminaire_firmware::entry!(spotlights);

/// The outer half angle, in degrees, as in the price list.
const HALF: f32 = 22.0;

/// A point and a normal in 16-bit fixed point.
type Site16 = (Vec3<Length>, Vec3<Fx16>);

fn spotlights() {
    begin_lines();
    floats();
    integers();
}

#[inline(never)]
fn sites() -> Sites {
    Sites::new(Population::Lit, cone(HALF).map_or(0.0, |cone| cone.outer_versine()))
}

#[inline(never)]
fn floats() {
    let mut sites = sites();
    let sites: [Site; COUNT] = array::from_fn(|_| sites.next().expect("an endless sequence"));
    let theirs = theirs(HALF);
    run("embedded-3dgfx.f32", &sites, word, |site| {
        theirs.contribution_at(Point3::new(site.point.x, site.point.y, site.point.z))
    });
    let (Ok(light), Ok(light16)) = (ours::<f32>(HALF), ours::<Fx16>(HALF)) else { return };
    run("cone.f32", &sites, word, |site| cone32(&light, site.point));
    run("pixel.f32", &sites, word, |site| pixel(&light, site.point, site.normal));
    run("cone-of-floats.fx16", &sites, word, |site| cone16(&light16, Fx16::point(site.point.into())));
}

#[inline(never)]
fn integers() {
    let mut sites = sites();
    let sites: [Site16; COUNT] = array::from_fn(|_| {
        let Site { point, normal } = sites.next().expect("an endless sequence");
        (Fx16::point(point.into()), Fx16::normal(normal.into()))
    });
    let Ok(light) = ours::<Fx16>(HALF) else { return };
    let word = |(point, _): &Site16| point.x.to_bits() as u32;
    run("cone.fx16", &sites, word, |(point, _)| cone16(&light, *point));
    run("pixel.fx16", &sites, word, |(point, normal)| pixel(&light, *point, *normal));
}

fn word(site: &Site) -> u32 {
    site.point.x.to_bits()
}

// Not inlined: each kernel has its own copy of the loop.
#[inline(never)]
fn run<I>(name: &str, inputs: &[I; COUNT], word: impl Fn(&I) -> u32, kernel: impl Fn(&I) -> Rgb565) {
    let (kernel_name, format) = name.split_once('.').unwrap_or_default();
    report("empty", format, pass(inputs, word));
    report(kernel_name, format, pass(inputs, |input| kernel(input).into_storage().into()));
}
