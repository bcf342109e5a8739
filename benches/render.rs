//! What a picture of the stage costs at 960 x 540, pass by pass: geometry, light of three and of
//! eight spotlights, and encoding. Also the light of scenes with many lights, and a shadow map.
//!
//! `cargo bench --bench render`.

#![allow(missing_docs, reason = "criterion's macros make public items without documentation")]

use std::{hint::black_box, ops::Range, time::Instant};

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use luminaire::{
    Angle, Fx16, Fx32, Vec3,
    dynamic::AnyLight,
    projector::{Fixture, Projection},
};
use luminaire_render::{
    Camera, Format, Renderer, Scene, ShadowMap,
    scenes::stage,
    scenes::{Example, Setup, turntable},
};

const SIZE: (usize, usize) = (960, 540);

/// A renderer with two inputs for each pass. The passes alternate between them, because the
/// renderer does not repeat a pass whose input has not changed.
struct Bench<S: Format> {
    renderer: Renderer<S>,
    scene: Scene,
    cameras: [Camera; 2],
    lights: [Vec<Fixture>; 2],
}

impl<S: Format> Bench<S> {
    /// Draws a picture once, and asserts that the share of lit pixels is in `lit`.
    fn new(scene: Scene, camera: Camera, lights: [Vec<Fixture>; 2], lit: Range<f32>) -> Self {
        let mut beside = camera;
        beside.orbit(0.01, 0.0);
        let renderer = Renderer::new(SIZE.0, SIZE.1).expect("a sound size");
        let mut bench = Self { renderer, scene, cameras: [beside, camera], lights };
        bench.draw_geometry();
        bench.draw_light();
        let pixels = bench.renderer.encode().chunks_exact(4);
        let count = pixels.filter(|pixel| pixel[..3].iter().any(|&code| code > 32)).count();
        let share = count as f32 / (SIZE.0 * SIZE.1) as f32;
        assert!(lit.contains(&share), "{}: {share} of the picture is lit", S::NAME);
        bench
    }

    /// The stage under `spots` spotlights.
    fn stage(spots: usize) -> Self {
        let lights = stage::lights().expect("sound lights").into_iter().cycle().take(spots);
        let lights: Vec<Fixture> = lights.map(Fixture::from).collect();
        Self::new(
            stage::scene().expect("a sound scene"),
            stage::camera(),
            [brighter(&lights), lights],
            0.5..0.95,
        )
    }

    fn draw_geometry(&mut self) {
        self.cameras.swap(0, 1);
        assert!(self.renderer.draw_geometry(&self.scene, &self.cameras[0]));
    }

    fn draw_light(&mut self) {
        self.lights.swap(0, 1);
        assert!(self.renderer.draw_light(&self.lights[0]).expect("every format holds the lights"));
    }
}

/// The same spotlights, each brighter by a thousandth.
fn brighter(lights: &[Fixture]) -> Vec<Fixture> {
    let brighter = |light: &Fixture| match light.light() {
        AnyLight::Spot(spot) => {
            spot.with_intensity(1.001 * spot.intensity()).expect("a sound intensity").into()
        }
        other => panic!("{other:?}"),
    };
    lights.iter().map(brighter).collect()
}

fn bench<S: Format>(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("render");
    group.throughput(Throughput::Elements((SIZE.0 * SIZE.1) as u64));
    group.sample_size(20);
    let mut stage = Bench::<S>::stage(3);
    group.bench_function(format!("geometry {}", S::NAME), |bencher| bencher.iter(|| stage.draw_geometry()));
    for spots in [3, 8] {
        let mut stage = Bench::<S>::stage(spots);
        group.bench_function(format!("light of {spots} {}", S::NAME), |bencher| {
            bencher.iter(|| stage.draw_light());
        });
    }
    group.finish();
}

/// Scenes in which every light changes from one picture to the next.
fn scenes(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("render");
    group.throughput(Throughput::Elements((SIZE.0 * SIZE.1) as u64));
    group.sample_size(20);
    let mut bench = |name: &str, setup: Setup, next: &dyn Fn(&[Fixture]) -> Vec<Fixture>, lit: Range<f32>| {
        let lights = setup.fixtures_at(0.0).expect("sound lights");
        let lights = [next(&lights), lights];
        let mut bench = Bench::<f32>::new(setup.scene, setup.camera, lights, lit);
        group.bench_function(name, |bencher| bencher.iter(|| bench.draw_light()));
    };
    for (name, example) in [("grid", Example::Grid), ("wide grid", Example::WideGrid)] {
        bench(name, example.setup().expect("a sound scene"), &brighter, 0.2..0.35);
    }
    for spots in [8, 32] {
        let setup = turntable(spots).expect("a sound scene");
        let moved = setup.fixtures_at(0.02).expect("sound lights");
        bench(&format!("turntable of {spots}"), setup, &|_| moved.clone(), 0.7..0.95);
    }
    group.finish();
}

/// A shadow map of the whole stage, drawn for the light that sees the most of the stage. It
/// alternates between two rolls.
fn shadow_map<S: Format>(criterion: &mut Criterion) {
    let (scene, [_, fill, _]) =
        (stage::scene().expect("a sound scene"), stage::lights().expect("sound lights"));
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
    // A point in the sphere's shadow, and one on top of the sphere.
    let visibility = |x, y, z| {
        let point = Vec3::new(x, y, z).map(S::length);
        map.shadow().map(|shadow| shadow.visibility(point))
    };
    assert_eq!([visibility(-0.9, 0.001, -0.1), visibility(-0.52, 1.12, 0.3)], [Some(S::ZERO), Some(S::ONE)]);
}

/// Only the encoding is timed. Light is drawn before, because the renderer encodes only a picture
/// that has changed.
fn encode(criterion: &mut Criterion) {
    let mut stage = Bench::<f32>::stage(3);
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
    scenes,
    shadow_map::<f32>,
    shadow_map::<Fx16>,
    encode
);
criterion_main!(benches);
