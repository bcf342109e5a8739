//! A light of the kernel, beside the same light that `luminaire export` wrote as C.

use core::array;

use luminaire::{Fx16, Length, Vec3, falloff::Soft, light::CompiledSpotLight};
use luminaire_kernels::scene::{Random, unit};

use crate::COUNT;
use crate::board::println;
use crate::measure::pass;

/// The light, compiled by the build script.
const KEY: CompiledSpotLight<Fx16, Soft> = include!(concat!(env!("OUT_DIR"), "/key.rs"));

mod c {
    unsafe extern "C" {
        /// The irradiance of the light, which the build script exported and compiled.
        pub(super) safe fn exported(point: &[i32; 3], normal: &[i16; 3]) -> u32;
    }
}

/// The words of a point and of a normal.
struct Input([i32; 3], [i16; 3]);

/// Runs both over surface points under the light, and prints lines as [`measure`](crate::measure())
/// does.
pub fn exported() {
    let mut random = Random::new();
    let inputs = array::from_fn(|_| Input::random(&mut random));
    run("rust", &inputs, |Input(point, normal)| irradiance(point, normal));
    run("c", &inputs, |Input(point, normal)| c::exported(point, normal));
}

/// The irradiance of the light. Not inlined, as the C is not.
#[inline(never)]
fn irradiance(point: &[i32; 3], normal: &[i16; 3]) -> u32 {
    let point = Vec3::from(*point).map(Length::from_bits);
    KEY.irradiance(point, Vec3::from(*normal).map(Fx16::from_bits)).to_bits()
}

impl Input {
    /// A point up to a metre above the floor, with a normal that points up.
    fn random(random: &mut Random) -> Self {
        let mut within = |low: f32, high: f32| low + (high - low) * (random.number() + 1.0) / 2.0;
        let point = [within(-2.0, 1.6), within(0.0, 1.0), within(-1.6, 1.6)];
        let normal = unit(Vec3::new(within(-0.3, 0.3), 1.0, within(-0.3, 0.3)));
        Self(point.map(|c| Length::from_f32(c).to_bits()), normal.map(|c| Fx16::from_f32(c).to_bits()).into())
    }
}

// Not inlined: each kernel has its own copy of the loop.
#[inline(never)]
fn run(name: &str, inputs: &[Input; COUNT], kernel: impl Fn(&Input) -> u32) {
    report("empty", pass(inputs, |Input(point, normal)| point[0] as u32 ^ normal[0] as u32));
    report(name, pass(inputs, kernel));
}

#[inline(never)]
fn report(name: &str, sum: u32) {
    println!("exported fx16 {name} {COUNT} {sum:08x}");
}
