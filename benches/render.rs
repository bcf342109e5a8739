//! What a picture of the stage costs at 960 x 540, pass by pass, in one run: geometry, light of three and of
//! eight spots, encoding; and what a shadow map of it costs.
//!
//! `cargo bench --bench render`.

#![allow(missing_docs, reason = "criterion's macros make public items without documentation")]

use std::{hint::black_box, time::Instant};

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use luminaire::{Angle, Fx16, Fx32, Projection, Spot, Vec3};
use luminaire_render::{Camera, Format, Renderer, Scene, ShadowMap, stage};

const SIZE: (usize, usize) = (960, 540);

/// The renderer keeps what has not changed: each pass alternates between two inputs.
struct Stage<S: Format> {
    renderer: Renderer<S>,
    scene: Scene,
    cameras: [Camera; 2],
    lights: [Vec<Spot>; 2],
}

impl<S: Format> Stage<S> {
    fn new(spots: usize) -> Self {
        let mut beside = stage::camera();
        beside.orbit(0.01, 0.0);
        let lights: Vec<_> = stage::lights().expect("sound lights").into_iter().cycle().take(spots).collect();
        let brighter =
            |spot: &Spot| spot.with_intensity(1.001 * spot.intensity()).expect("a sound intensity");
        let brighter = lights.iter().map(brighter).collect();
        let renderer = Renderer::new(SIZE.0, SIZE.1).expect("a sound size");
        let mut stage = Self {
            renderer,
            scene: stage::scene(),
            cameras: [beside, stage::camera()],
            lights: [brighter, lights],
        };
        stage.draw_geometry();
        stage.draw_light();
        let lit =
            stage.renderer.encode().chunks_exact(4).filter(|pixel| pixel[..3].iter().any(|&code| code > 32));
        let share = lit.count() as f32 / (SIZE.0 * SIZE.1) as f32;
        assert!((0.5..0.95).contains(&share), "{}: {share} of the stage is lit", S::NAME);
        stage
    }

    fn draw_geometry(&mut self) {
        self.cameras.swap(0, 1);
        assert!(self.renderer.draw_geometry(&self.scene, &self.cameras[0]));
    }

    fn draw_light(&mut self) {
        self.lights.swap(0, 1);
        assert!(self.renderer.draw_light(&self.lights[0]).expect("every format holds the stage"));
    }
}

fn bench<S: Format>(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("render");
    group.throughput(Throughput::Elements((SIZE.0 * SIZE.1) as u64));
    group.sample_size(20);
    let mut stage = Stage::<S>::new(3);
    group.bench_function(format!("geometry {}", S::NAME), |bencher| bencher.iter(|| stage.draw_geometry()));
    for spots in [3, 8] {
        let mut stage = Stage::<S>::new(spots);
        group.bench_function(format!("light of {spots} {}", S::NAME), |bencher| {
            bencher.iter(|| stage.draw_light());
        });
    }
    group.finish();
}

/// A shadow map of the whole stage, of the light that sees the most of it, from another roll each time.
fn shadow_map<S: Format>(criterion: &mut Criterion) {
    let (scene, [_, fill, _]) = (stage::scene(), stage::lights().expect("sound lights"));
    let square = Projection::of(&fill).expect("not too wide");
    let mut squares = [square, square.turned(Angle::degrees(1.0)).expect("sound")];
    let mut map = ShadowMap::<S>::new(512).expect("a sound side");
    criterion.benchmark_group("render").sample_size(20).bench_function(
        format!("shadow map of 512 {}", S::NAME),
        |bencher| {
            bencher.iter(|| {
                squares.swap(0, 1);
                assert_eq!(map.draw(&scene, &squares[0]), Ok(true));
            });
        },
    );
    // Behind the sphere, and on its top.
    let visibility = |x, y, z| {
        let point = Vec3::new(x, y, z).map(S::length);
        map.shadow().map(|shadow| shadow.visibility(point))
    };
    assert_eq!([visibility(-0.9, 0.001, -0.1), visibility(-0.52, 1.12, 0.3)], [Some(S::ZERO), Some(S::ONE)]);
}

/// Only the encoding is timed; the light before it is what makes it due.
fn encode(criterion: &mut Criterion) {
    let mut stage = Stage::<f32>::new(3);
    let mut group = criterion.benchmark_group("render");
    group.throughput(Throughput::Elements((SIZE.0 * SIZE.1) as u64));
    group.bench_function("encode", |bencher| {
        bencher.iter_custom(|turns| {
            let timed = (0..turns).map(|_| {
                stage.draw_light();
                let start = Instant::now();
                black_box(stage.renderer.encode());
                start.elapsed()
            });
            timed.sum()
        });
    });
    group.finish();
}

criterion_group!(
    benches,
    bench::<f32>,
    bench::<Fx32>,
    bench::<Fx16>,
    shadow_map::<f32>,
    shadow_map::<Fx16>,
    encode
);
criterion_main!(benches);
