//! Runs each kernel over its inputs between the markers, and prints a checksum of its results.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::{Fx16, Fx32, Hard, Scalar, Soft};
use luminaire_firmware::scene::{self, Population};
use luminaire_firmware::{Bits, Inputs, board::opaque};

luminaire_firmware::entry!(cost);

fn cost() {
    falloffs::<Fx16>();
    falloffs::<Fx32>();
    falloffs::<f32>();
    points::<Fx16>();
    points::<Fx32>();
    points::<f32>();
    rivals();
}

/// From a versine to the intensity.
#[inline(never)]
fn falloffs<S: Scalar<Versine: Bits> + Bits>() {
    let cone = scene::cone(Soft).expect("a cone that exists");
    let soft = cone.compile::<S>().expect("a cone that every format holds");
    let hard = soft.with_profile(Hard);
    let versines = scene::versines(&cone, &soft);
    let inputs = Inputs::new(S::NAME, "versines", &versines, |versine| *versine);
    let (soft, hard) = (opaque(&soft), opaque(&hard));
    inputs.run("soft", |versine| soft.at(*versine));
    inputs.run("hard", |versine| hard.at(*versine));
}

/// The complete lit point: a soft cone, Lambert's cosine and the inverse square of the distance.
fn points<S: Scalar<Length: Bits, Irradiance: Bits>>() {
    population::<S>("lit", Population::Lit);
    population::<S>("away", Population::Away);
    population::<S>("outside", Population::Outside);
}

/// One kind of points. Never inlined: the smallest board's memory holds a single table.
#[inline(never)]
fn population<S: Scalar<Length: Bits, Irradiance: Bits>>(name: &str, population: Population) {
    let light = scene::spot().and_then(|spot| spot.compile::<S>()).expect("a light that every format holds");
    let light = opaque(&light);
    let samples = scene::samples::<S>(population);
    let inputs = Inputs::new(S::NAME, "points", &samples, |sample| sample.point.x);
    inputs.run(name, |sample| light.irradiance(sample.point, sample.normal));
}

/// What a falloff would cost by the power of a cosine, and what a loop costs that does next to nothing.
#[inline(never)]
fn rivals() {
    let cone = scene::cone(Soft).expect("a cone that exists");
    let falloff = cone.compile::<f32>().expect("a cone that f32 holds");
    let cosines = scene::versines(&cone, &falloff).map(|versine| 1.0 - versine);
    let inputs = Inputs::new(f32::NAME, "cosines", &cosines, |cosine| *cosine);
    let exponent = opaque(&12.5);
    inputs.run("powf", |cosine| libm::powf(*cosine, *exponent));
    inputs.run("clamp", |cosine| cosine.clamp(0.0, 1.0));
}
