//! What in-scattering costs for a view ray: from a picture's rays in memory to scattered light in
//! memory.
//!
//! `cargo bench --bench haze`. The rays see a spotlight from the side, in blocks of 32 pixels as in
//! a renderer. About half of the picture is within the beam. The rival marches along the ray in
//! equal steps.

#![allow(missing_docs, reason = "criterion's macros make public items without documentation")]

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use luminaire::{
    Angle, Cone, SpotLight, Vec3,
    attenuation::{Attenuation, FilamentRange, InverseSquare},
    falloff::{Falloff, Hard, Soft},
    haze::{BeamScattering, Haze, ViewRay},
    light::CompiledSpotLight,
};

const WIDTH: usize = 256;
const HEIGHT: usize = 64;
const BLOCK: usize = 32;
const EYE: Vec3<f32> = Vec3::new(0.0, 2.0, 6.0);

/// A block of pixels: directions and lengths of their view rays, and room for the light.
#[derive(Clone, Copy)]
struct Block {
    direction: Vec3<[f32; BLOCK]>,
    length: [f32; BLOCK],
    light: [f32; BLOCK],
}

/// The view rays of a picture of a back wall.
fn picture() -> Vec<Block> {
    let mut blocks = Vec::new();
    for start in (0..WIDTH * HEIGHT).step_by(BLOCK) {
        let mut block = Block {
            direction: Vec3::new([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]),
            length: [0.0; BLOCK],
            light: [0.0; BLOCK],
        };
        for i in 0..BLOCK {
            let (x, y) = ((start + i) % WIDTH, (start + i) / WIDTH);
            let at = |place: usize, of: usize| place as f32 / of as f32 - 0.5;
            let wall = Vec3::new(8.0 * at(x, WIDTH), 2.0 + 4.0 * at(y, HEIGHT), -3.0);
            let view = ViewRay::between(EYE, wall);
            block.direction.x[i] = view.direction.x;
            block.direction.y[i] = view.direction.y;
            block.direction.z[i] = view.direction.z;
            block.length[i] = view.length;
        }
        blocks.push(block);
    }
    blocks
}

fn spot<P: Falloff>(falloff: P) -> SpotLight<P> {
    let cone = Cone::from_field(falloff, Angle::degrees(36.0)).expect("a sound angle");
    SpotLight::new(Vec3::new(0.3, 4.5, 0.2), Vec3::new(-0.05, -1.0, 0.0), cone)
        .and_then(|spot| spot.with_intensity(16.0))
        .expect("a sound light")
}

/// Stores `light` of each ray in the picture.
#[inline(always)]
fn fill(blocks: &mut [Block], light: impl Fn(&ViewRay) -> f32) {
    for block in blocks {
        for i in 0..BLOCK {
            let direction = Vec3::new(block.direction.x[i], block.direction.y[i], block.direction.z[i]);
            block.light[i] = light(&ViewRay { eye: EYE, direction, length: block.length[i] });
        }
    }
}

fn bench_with(criterion: &mut Criterion, name: &str, mut fill: impl FnMut(&mut [Block])) {
    let mut blocks = picture();
    fill(&mut blocks);
    let lights = blocks.iter().flat_map(|block| block.light);
    let (lit, brightest) = lights.fold((0, 0.0_f32), |(n, most), l| (n + u32::from(l > 0.0), most.max(l)));
    assert!((0.2..0.8).contains(&(f64::from(lit) / (WIDTH * HEIGHT) as f64)), "{name}: {lit} are lit");
    assert!((0.01..1.0).contains(&brightest), "{name}: the brightest is {brightest}");
    let mut group = criterion.benchmark_group("haze");
    group.throughput(Throughput::Elements((WIDTH * HEIGHT) as u64));
    group.bench_function(name, |bencher| bencher.iter(|| fill(black_box(&mut blocks))));
    group.finish();
}

fn bench<P: Falloff, A: Attenuation>(criterion: &mut Criterion, name: &str, spot: SpotLight<P, A>) {
    let beam: BeamScattering<P, A> =
        spot.compile::<f32>().expect("held").in_haze(&Haze::new(0.02).expect("a sound density"));
    bench_with(criterion, name, |blocks| fill(blocks, |view| beam.in_scattering(view)));
    bench_with(criterion, &format!("{name}, 16 samples"), |blocks| {
        fill(blocks, |view| {
            beam.in_scattering_through(view, 16, |point| if point.y > 0.0 { 1.0 } else { 0.5 })
        });
    });
}

/// The usual method: ray marching in `steps` equal steps.
fn march(light: &CompiledSpotLight<f32, Soft>, view: &ViewRay, steps: u32) -> f32 {
    let step = view.length / steps as f32;
    let mut sum = 0.0;
    for i in 0..steps {
        let s = (i as f32 + 0.5) * step;
        let point = view.eye.zip(view.direction, |e, d| e + s * d);
        let way = point.zip(Vec3::new(0.3, 4.5, 0.2), |p, l| p - l);
        sum += light.falloff_at(point) / way.dot(way);
    }
    16.0 * 0.02 / 4.0 * step * sum
}

fn haze(criterion: &mut Criterion) {
    bench::<_, InverseSquare>(criterion, "soft", spot(Soft));
    bench::<_, InverseSquare>(criterion, "hard", spot(Hard));
    let window = FilamentRange::new(InverseSquare, Some(9.0)).expect("a sound range");
    bench(criterion, "soft, squared window", spot(Soft).with_attenuation(window));
    let light = spot(Soft).compile::<f32>().expect("held");
    bench_with(criterion, "16 steps along the ray", |blocks| fill(blocks, |view| march(&light, view, 16)));
}

criterion_group!(benches, haze);
criterion_main!(benches);
