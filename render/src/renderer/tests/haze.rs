//! The error of haze that is interpolated between rays, against a ray through every pixel.
//!
//! `LUMINAIRE_FULL=1 cargo test --release -p luminaire-render --lib haze -- --nocapture` searches
//! longer, and prints the largest errors.

use super::*;
use crate::{
    light::{air::TileAir, rig::Rig},
    scenes::Example,
};
use core::f32::consts::TAU;
use luminaire::{
    Angle, Cone, SpotLight, Vec3, attenuation::AnyAttenuation, dynamic::AnyLight, falloff::AnyFalloff,
    haze::Haze, projector::Gobo,
};
use std::{println, vec, vec::Vec};

/// Largest error in linear codes: 1/255 of full scale, clipped at 1.
const BOUND: f32 = 0.5;

/// Largest error in a search, where light up to the nearer of two surfaces may exceed that up to the
/// farther one by the error of a ray: in beams of intensity 1,000 whose falloff is a table.
const SEARCHED: f64 = 0.6;

/// Returns the light of all beams in the air but those that are seen by shafts, interpolated and with
/// a ray through every pixel, and the numbers of rays of both.
fn air(renderer: &mut Renderer<f32>, fixtures: &[Fixture]) -> [(Vec<Radiance>, usize); 2] {
    let rig = Rig::<f32>::new(RenderPlan::new(), fixtures, renderer.haze).unwrap();
    let stride = renderer.geometry.columns;
    let dark = Rgb::default().map(|()| [0.0; LANES]);
    let mut found = [(); 2].map(|()| (vec![dark; renderer.radiance.len()], 0));
    for tile in 0..renderer.tiles.tiles.len() {
        renderer.sight(tile);
        let sight = renderer.tiles.tiles[tile].sight.as_ref();
        let view = renderer.view.as_ref().unwrap();
        let seen: Vec<_> = (0..fixtures.len()).filter(|&light| rig.is_seen_in_air(light, sight)).collect();
        let (rows, column) = renderer.tiles.place(tile);
        let columns = LANES.min(renderer.width - column * LANES);
        for (is_each, (radiance, rays)) in found.iter_mut().enumerate() {
            let radiance = &mut radiance[rows.start * stride + column..];
            let place = (rows.clone(), column);
            let mut air = TileAir::new(view, &renderer.fragments, place, columns, radiance, stride);
            for fixture in seen.iter().filter_map(|&light| rig.fixture(light)) {
                let (hazy, way, shafts) = fixture.in_air(&renderer.shadows, view.eye()).unwrap();
                if shafts.is_some() {
                    continue;
                }
                match is_each {
                    0 => air.add(hazy, &way, shafts, 1.0 / seen.len() as f32),
                    _ => air.add_each(hazy, &way),
                }
            }
            *rays += air.finish();
        }
    }
    found
}

/// Returns the largest difference in linear codes, and the numbers of rays per pixel, interpolated
/// and with a ray through every pixel.
fn error(renderer: &mut Renderer<f32>, fixtures: &[Fixture]) -> (f32, [f32; 2]) {
    let pixels = (renderer.width * renderer.height) as f32;
    let [(few, few_rays), (each, each_rays)] = air(renderer, fixtures);
    let mut worst = 0.0_f32;
    for (block, (few, each)) in few.iter().zip(&each).enumerate() {
        let columns = LANES.min(renderer.width - block % renderer.geometry.columns * LANES);
        for (few, each) in [(&few.red, &each.red), (&few.green, &each.green), (&few.blue, &each.blue)] {
            for (few, each) in few.iter().zip(each).take(columns) {
                worst = worst.max(255.0 * (few.min(1.0) - each.min(1.0)).abs());
                assert!(*few >= 0.0, "{few} is negative");
            }
        }
    }
    (worst, [few_rays, each_rays].map(|rays| rays as f32 / pixels))
}

/// Every hazy example from several cameras, at several times, with and without shadow maps.
#[test]
fn interpolated_haze_of_examples_errs_by_at_most_half_a_code() {
    let (width, height) = if is_full() { (960, 540) } else { (300, 170) };
    for &example in Example::ALL {
        let setup = example.setup().unwrap();
        if setup.scene.haze().is_none() {
            continue;
        }
        let (mut worst, mut count, mut sums) = (0.0_f32, 0.0, [0.0; 2]);
        let mut renderer = Renderer::<f32>::new(width, height).unwrap();
        for time in 0..if is_full() { 60 } else { 6 } {
            let time = time as f32;
            let mut camera = setup.camera;
            camera.orbit(0.7 * time, 0.05 * (time % 7.0) - 0.1);
            camera.zoom(1.0 - 0.08 * (time % 8.0));
            let mut fixtures = setup.fixtures_at(0.37 * time).unwrap();
            if time % 3.0 == 1.0 {
                for fixture in &mut fixtures {
                    *fixture = fixture.with_shadow(64).unwrap();
                }
            }
            renderer.draw_geometry(&setup.scene, &camera);
            renderer.draw_shadows(&setup.scene, &fixtures).unwrap();
            let (error, rays) = error(&mut renderer, &fixtures);
            worst = worst.max(error);
            count += 1.0;
            sums = [sums[0] + rays[0], sums[1] + rays[1]];
        }
        let rays = sums.map(|sum| sum / count);
        println!("{}: {worst:.3} linear codes, rays per pixel {rays:.3?}", example.name());
        assert!(worst <= BOUND, "{}: {worst} linear codes", example.name());
        assert!(rays[0] < 0.6 * rays[1], "{}: {rays:?} rays per pixel", example.name());
    }
}

/// Random numbers in [0, 1) that a [`Case`] is built from.
type Genes = [f32; GENES];

const GENES: usize = 8 + 2 * LIGHT;

/// Genes per light.
const LIGHT: usize = 14;

/// The view of a scene with a floor, a wall and round things, and one or two beams.
struct Case {
    camera: Camera,
    fixtures: Vec<Fixture>,
}

impl Case {
    /// The lights are in the scene, at the eye or behind it, and point anywhere, past the eye, away
    /// from it or across the line of sight.
    fn new(genes: &Genes) -> Option<Self> {
        let (view, lights) = genes.split_at(8);
        let target = Vec3::new(4.0 * view[0] - 2.0, 0.2 + 2.5 * view[1], 3.0 * view[2] - 1.5);
        let distance = 0.3 * 60.0_f32.powf(view[3]);
        let field_of_view = 0.02 * 60.0_f32.powf(view[6]);
        let camera =
            Camera::new(target, distance, TAU * view[4], 1.4 * view[5] * view[5] - 0.1, field_of_view);
        let count = if view[7] < 0.7 { 1 } else { 2 };
        let fixtures = lights.chunks(LIGHT).take(count).map(|genes| Self::fixture(genes, &camera, target));
        let fixtures: Vec<Fixture> = fixtures.collect::<Option<_>>()?;
        // Some cones are too narrow to be compiled.
        Rig::<f32>::new(RenderPlan::new(), &fixtures, None).ok()?;
        Some(Self { camera, fixtures })
    }

    fn fixture(genes: &[f32], camera: &Camera, target: Vec3<f32>) -> Option<Fixture> {
        let (eye, target) = (glam::Vec3::from(camera.eye()), glam::Vec3::from(target));
        let offset = |genes: &[f32]| glam::Vec3::new(genes[0], genes[1], genes[2]) * 2.0 - 1.0;
        let along = eye + (target - eye) * (2.0 * genes[1] - 0.4);
        let scale = 0.01 * 400.0_f32.powf(genes[2]);
        let position = match (4.0 * genes[0]) as usize {
            0 => glam::Vec3::new(0.0, 2.5, 0.0) + offset(&genes[3..]) * glam::Vec3::new(4.0, 2.0, 4.0),
            1 => eye + offset(&genes[3..]) * scale,
            _ => along + offset(&genes[3..]) * scale,
        };
        let aim = match (5.0 * genes[6]) as usize {
            0 => offset(&genes[7..]),
            1 => eye - position + offset(&genes[7..]) * scale,
            2 => position - eye + offset(&genes[7..]) * scale,
            3 => target - position + offset(&genes[7..]) * scale,
            _ => target - eye + offset(&genes[7..]) * 0.3,
        };
        let falloff = AnyFalloff::samples().nth((genes[10] * AnyFalloff::COUNT as f32) as usize)?;
        let outer = 0.3 * 500.0_f32.powf(genes[11]);
        let mut cone = Cone::from_outer(falloff, Angle::degrees(outer)).ok()?;
        if genes[13] > 0.6 {
            cone = cone.with_inner(Angle::degrees(outer * (2.4 * genes[13] - 1.44))).ok()?;
        }
        let mut spot = SpotLight::new(Vec3::from(position), Vec3::from(aim), cone).ok()?;
        spot = spot.with_intensity(0.5 * 2000.0_f32.powf(genes[12])).ok()?;
        let dyed = Rgb::new(1.0, genes[9], genes[8]);
        let spot = spot.with_color(dyed).ok()?;
        let light = if genes[9] > 0.7 {
            let number = (genes[8] * AnyAttenuation::COUNT as f32) as usize;
            AnyLight::from(spot.with_attenuation(AnyAttenuation::drawn(number, || genes[7]).ok()?))
        } else {
            AnyLight::from(spot)
        };
        let fixture = Fixture::from(light);
        match (10.0 * genes[7]) as usize {
            0 => fixture.with_gobo(Gobo::of(&STAR), Angle::degrees(360.0 * genes[8])).ok(),
            1 => fixture.with_gobo(Gobo::of(&STRIPES), Angle::degrees(360.0 * genes[8])).ok(),
            2 => fixture.with_shadow(64).ok(),
            _ => Some(fixture),
        }
    }
}

/// Random views and beams in pictures of random sizes, and climbs by bits from the worst of them.
#[test]
fn interpolated_haze_keeps_its_bound_in_a_search() {
    let (seeds, starts, steps) = if is_full() { (60, 400, 600) } else { (5, 60, 60) };
    let mut worst = 0.0_f64;
    for seed in 0..seeds {
        let mut renderer = picture(seed);
        let body = 0.001 * 500.0_f32.powf(Rng::with_seed(!seed).f32());
        let scene = hazy(Haze::new(0.05).and_then(|haze| haze.with_source_radius(body)).unwrap());
        let (found, genes) = super::worst(seed, (starts, steps), |genes| {
            let Some(case) = Case::new(genes) else { return 0.0 };
            renderer.draw_geometry(&scene, &case.camera);
            renderer.draw_shadows(&scene, &case.fixtures).unwrap();
            f64::from(error(&mut renderer, &case.fixtures).0)
        });
        if found > worst {
            worst = found;
            println!("seed {seed}: {worst:.3} linear codes at {genes:?}");
        }
    }
    println!("{seeds} climbs of {} cases: {worst:.3} linear codes", starts + steps);
    assert!(worst <= SEARCHED, "{worst} linear codes");
}
