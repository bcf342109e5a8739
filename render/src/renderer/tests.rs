//! White-box tests of the passes: the G-buffer, and the light computed from the G-buffer.

use super::*;
use crate::{
    Mesh, Outline,
    scenes::{gobos, solids::sphere, stage},
};
use core::f32::consts::PI;
use fastrand::Rng;
use luminaire::Vec3;

extern crate std;

mod haze;
mod shafts;

const SIZE: (usize, usize) = (160, 90);

const STAR: [u8; 64 * 64] = gobos::star();

/// Stripes as narrow as a gobo can have them.
const STRIPES: [u8; 64 * 64] = {
    let mut stripes = [0; 64 * 64];
    let mut i = 0;
    while i < stripes.len() {
        stripes[i] = if i % 2 == 0 { u8::MAX } else { 0 };
        i += 1;
    }
    stripes
};

fn renderer<S: Format>(scene: &Scene, camera: &Camera) -> Renderer<S> {
    let mut renderer = Renderer::new(SIZE.0, SIZE.1).unwrap();
    assert!(renderer.draw_geometry(scene, camera));
    renderer
}

fn scene(meshes: impl IntoIterator<Item = Mesh>) -> Scene {
    let mut scene = Scene::new();
    let white = Material::srgb(255, 255, 255);
    meshes.into_iter().for_each(|mesh| scene.add(mesh, white).unwrap());
    scene
}

/// Returns the position, the normal and the material of a pixel of the G-buffer.
fn fragment<S: Format>(renderer: &Renderer<S>, x: usize, y: usize) -> (Vec3<S::Length>, Vec3<S>, u32) {
    let block = &renderer.geometry.blocks[y * renderer.width.div_ceil(LANES) + x / LANES];
    let lane = x % LANES;
    let point = Vec3::new(block.point.x[lane], block.point.y[lane], block.point.z[lane]);
    let normal = Vec3::new(block.normal.x[lane], block.normal.y[lane], block.normal.z[lane]);
    (point, normal, block.material[lane])
}

/// Returns all pixels of the G-buffer in which something was drawn.
fn fragments<S: Format>(renderer: &Renderer<S>) -> impl Iterator<Item = (Vec3<S::Length>, Vec3<S>, u32)> {
    let pixels = (0..renderer.height).flat_map(|y| (0..renderer.width).map(move |x| (x, y)));
    pixels.map(|(x, y)| fragment(renderer, x, y)).filter(|(_, _, material)| *material != 0)
}

/// Whether the searches are long ones.
fn is_full() -> bool {
    std::env::var_os("LUMINAIRE_FULL").is_some()
}

/// A floor and a wall with round things in haze.
fn hazy(haze: Haze) -> Scene {
    let cuboid = Mesh::cuboid(0.4, 1.2, 0.4).moved(Vec3::new(1.4, 0.6, 0.5));
    let floor = Mesh::cuboid(30.0, 0.2, 30.0).moved(Vec3::new(0.0, -0.1, 0.0));
    let wall = Mesh::cuboid(8.0, 4.0, 0.2).moved(Vec3::new(0.0, 2.0, -3.0));
    let mut scene = scene([floor, wall, cuboid, sphere(0.6).moved(Vec3::new(-0.5, 0.6, 0.0))]);
    scene.set_haze(Some(haze));
    scene
}

/// Returns the largest error of random cases, each built from numbers in [0, 1), and of a climb by bits from
/// the worst of them, and its numbers. NaN is an infinite error.
fn worst<const N: usize>(
    seed: u64,
    (starts, steps): (usize, usize),
    mut error: impl FnMut(&[f32; N]) -> f64,
) -> (f64, [f32; N]) {
    let mut rng = Rng::with_seed(seed);
    let mut worst = (f64::NEG_INFINITY, [0.0; N]);
    for number in 0..starts + steps {
        let climbs = number >= starts;
        let genes = if climbs { moved(&mut rng, worst.1) } else { core::array::from_fn(|_| rng.f32()) };
        let error = error(&genes);
        let error = if error.is_nan() { f64::INFINITY } else { error };
        // A climb crosses plateaus.
        if error > worst.0 || (climbs && error == worst.0) {
            worst = (error, genes);
        }
    }
    worst
}

/// The numbers with one of them changed, by a power of two from 2^-1 on or by that many units in the last
/// place.
fn moved<const N: usize>(rng: &mut Rng, mut genes: [f32; N]) -> [f32; N] {
    let gene = &mut genes[rng.usize(..N)];
    let size = 0.5_f32.powi(rng.i32(1..24)) * if rng.bool() { 1.0 } else { -1.0 };
    let units = (1_i32 << rng.u8(..24)) * if rng.bool() { 1 } else { -1 };
    let stepped = f32::from_bits(gene.to_bits().saturating_add_signed(units));
    *gene = if rng.bool() { *gene + size } else { stepped }.clamp(0.0, 0.999_999);
    genes
}

/// A picture of up to 320 x 180 pixels.
fn picture(seed: u64) -> Renderer<f32> {
    let mut rng = Rng::with_seed(seed);
    let [width, height] = [320.0, 180.0].map(|most: f32| (most * 16.0_f32.powf(-rng.f32())) as usize);
    Renderer::new(width, height).unwrap()
}

#[test]
fn from_inside_a_closed_mesh_there_is_no_crack() {
    // An outline drawn downwards faces inwards.
    let outline = Outline::start(0.0, 2.0).arc(0.0, 0.0, -PI, 29);
    let room = Mesh::lathe(&outline, 61).moved(Vec3::new(0.0, 1.0, 0.0));
    let scene = scene([room]);
    for step in 0..60 {
        let turn = step as f32;
        let target = Vec3::new(0.4 * (turn * 0.7).sin(), 0.6 + 0.3 * (turn * 1.3).sin(), 0.0);
        let camera =
            Camera::new(target, 0.25 + 0.02 * turn, turn * 0.37, (turn * 0.9).sin(), 0.3 + 0.03 * turn);
        let eye = camera.eye();
        let inside = (eye.x * eye.x + (eye.y - 1.0) * (eye.y - 1.0) + eye.z * eye.z).sqrt() < 1.9;
        if inside {
            let covered = fragments(&renderer::<f32>(&scene, &camera)).count();
            assert_eq!(covered, SIZE.0 * SIZE.1, "cracks seen by {camera:?}");
        }
    }
}

#[test]
fn a_floor_that_runs_under_the_eye_is_cut_at_the_near_plane() {
    let floor = Outline::start(500.0, 0.0).line_to(-500.0, 0.0);
    let floor = Mesh::extrude(&floor, 1000.0, 1).moved(Vec3::new(0.0, 0.0, -500.0));
    let camera = Camera::new(Vec3::new(0.0, 0.5, 0.0), 3.0, 0.4, 0.0, 1.4);
    let renderer = renderer::<f32>(&scene([floor]), &camera);
    for x in 0..SIZE.0 {
        for y in 0..SIZE.1 {
            let below_horizon = y >= SIZE.1 / 2;
            assert_eq!(fragment(&renderer, x, y).2 != 0, below_horizon, "pixel {x}, {y}");
        }
    }
}

#[test]
fn costs_of_all_pixels_add_up_to_the_time_of_the_pass() {
    use std::sync::atomic::{AtomicU32, Ordering};
    static LOOKS: AtomicU32 = AtomicU32::new(0);
    /// Advances by one at each look.
    fn clock() -> f64 {
        LOOKS.fetch_add(1, Ordering::Relaxed).into()
    }
    let mut renderer = renderer::<f32>(&stage::scene().unwrap(), &stage::camera());
    let lights = stage::lights().unwrap();
    renderer.draw_light(&lights).unwrap();
    assert_eq!(renderer.cost(0, 0), Some(0.0));
    renderer.set_clock(Some(clock));
    let before = clock();
    assert!(renderer.draw_light(&lights).unwrap(), "a first clock has the picture lit again");
    let after = clock();
    let costs = (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (x, y)));
    let sum: f64 = costs.map(|(x, y)| renderer.cost(x, y).unwrap()).sum();
    // The first look of the pass is one after `before`, and its last one is one before `after`.
    let time = after - before - 2.0;
    assert!(time > 5.0 && (sum - time).abs() < 1e-9 * time, "{sum} in place of {time}");
    assert_eq!(renderer.cost(SIZE.0, 0), None);
}
