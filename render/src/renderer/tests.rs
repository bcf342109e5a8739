//! White-box tests of the passes: the G-buffer, and the light computed from the G-buffer.

use super::*;
use crate::{Mesh, Outline, scenes::stage};
use core::f32::consts::PI;
use luminaire::{Angle, Cone, Fx16, Fx32, SpotLight, Vec3, falloff::SoftOrHard};

extern crate std;

mod haze;
mod shafts;

const SIZE: (usize, usize) = (160, 90);

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

fn sphere(radius: f32, center: Vec3<f32>) -> Mesh {
    let outline = Outline::start(0.0, -radius).arc(0.0, 0.0, PI, 96);
    Mesh::lathe(&outline, 192).moved(center)
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

#[test]
fn a_plane_has_its_position_and_normal_in_the_buffer() {
    let floor = Outline::start(40.0, 0.0).line_to(-40.0, 0.0);
    let floor = Mesh::extrude(&floor, 80.0, 1).moved(Vec3::new(0.0, 0.0, -40.0));
    let camera = Camera::new(Vec3::new(1.0, 0.0, 2.0), 5.0, 0.7, 0.5, 0.8);
    let renderer = renderer::<f32>(&scene([floor]), &camera);
    let mut largest = 0.0_f32;
    for (point, normal, _) in fragments(&renderer) {
        assert!(normal.x == 0.0 && (normal.y - 1.0).abs() < 2e-7 && normal.z == 0.0, "{normal:?}");
        largest = largest.max(point.y.abs());
    }
    assert!((1e-7..2e-4).contains(&largest), "off the plane by {largest} m");
    // The target is in the middle of the picture, between the four pixels there.
    let (x, y) = (SIZE.0 / 2, SIZE.1 / 2);
    let (a, b) = (fragment(&renderer, x - 1, y - 1).0, fragment(&renderer, x, y).0);
    assert!(((a.x + b.x) / 2.0 - 1.0).abs() < 2e-3 && ((a.z + b.z) / 2.0 - 2.0).abs() < 2e-3, "{a:?} {b:?}");
}

#[test]
fn a_sphere_has_its_position_and_normal_in_the_buffer() {
    let center = Vec3::new(0.5, 1.0, -0.25);
    let renderer = renderer::<f32>(&scene([sphere(1.0, center)]), &Camera::new(center, 4.0, 0.3, 0.4, 0.6));
    let (mut off_surface, mut off_normal, mut count) = (0.0_f32, 0.0_f32, 0);
    for (point, normal, _) in fragments(&renderer) {
        let radial = point.zip(center, |p, c| p - c);
        let radius = radial.dot(radial).sqrt();
        off_surface = off_surface.max((radius - 1.0).abs());
        let error = normal.zip(radial, |n, r| n - r / radius);
        off_normal = off_normal.max(error.dot(error).sqrt());
        assert!((normal.dot(normal) - 1.0).abs() < 1e-6);
        count += 1;
    }
    assert!(count > 1000);
    // The chord of 1/192 of a turn is at most 1.4e-4 radii inside the circle, and a facet has two
    // such chords.
    assert!((2.5e-4..4e-4).contains(&off_surface), "off the surface by {off_surface}");
    assert!((1e-5..3e-3).contains(&off_normal), "normal off by {off_normal}");
}

#[test]
fn a_sphere_covers_the_area_of_its_silhouette() {
    for (distance, field_of_view) in [(4.0_f32, 0.6_f32), (2.5, 1.2), (9.0, 0.25)] {
        let center = Vec3::new(0.0, 1.5, 0.0);
        let camera = Camera::new(center, distance, 1.0, 0.2, field_of_view);
        let renderer = renderer::<f32>(&scene([sphere(1.0, center)]), &camera);
        let radius = (1.0 / distance).asin().tan() / (field_of_view / 2.0).tan() * SIZE.1 as f32 / 2.0;
        let (covered, expected) = (fragments(&renderer).count() as f32, PI * radius * radius);
        assert!((covered / expected - 1.0).abs() < 0.01, "{covered} pixels, {expected} expected");
    }
}

#[test]
fn what_is_nearer_hides_what_is_farther_in_either_order() {
    let near = || sphere(0.5, Vec3::new(0.0, 1.0, 1.0));
    let far = || sphere(0.9, Vec3::new(0.0, 1.0, -1.0));
    let camera = Camera::new(Vec3::new(0.0, 1.0, 0.0), 6.0, 0.0, 0.0, 0.6);
    for (meshes, nearer) in [([near(), far()], 1), ([far(), near()], 2)] {
        let renderer = renderer::<f32>(&scene(meshes), &camera);
        assert_eq!(fragment(&renderer, SIZE.0 / 2, SIZE.1 / 2).2, nearer);
        assert_eq!(fragments(&renderer).map(|(_, _, m)| m).max(), Some(2), "the far one looks out behind");
    }
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
fn odd_meshes_and_cameras_are_drawn_without_a_panic() {
    let odd = [f32::NAN, f32::INFINITY, -f32::INFINITY, f32::MAX, 1e30, 1e-30, 0.0, -1.0];
    let mut meshes = std::vec![Mesh::default()];
    for &a in &odd {
        for &b in &odd {
            let outline =
                Outline::start(a, b).line_to(b, 1.0).line_to(0.0, a).curve_to([(a, b), (b, a)], 1.0, b, 3);
            meshes.push(Mesh::lathe(&outline, 5).and(Mesh::extrude(&outline, b, 2)));
            meshes.push(
                Mesh::cuboid(a, b, 1.0).turned(Vec3::new(a, 0.0, 1.0), b).moved(Vec3::new(0.0, b, 0.0)),
            );
            meshes.push(Mesh::lathe(&outline, 0).and(Mesh::extrude(&outline, 1.0, 0)));
        }
    }
    let mut scene = Scene::new();
    let added = meshes.into_iter().map(|mesh| scene.add(mesh, Material::srgb(255, 255, 255)));
    let accepted = added.filter(Result::is_ok).count();
    assert!((10..100).contains(&accepted), "{accepted} meshes are accepted");
    let lights = stage::lights().unwrap();
    for &value in &odd {
        let mut camera = Camera::new(Vec3::new(value, 1.0, value), value, value, value, value);
        camera.orbit(value, value);
        camera.zoom(value);
        assert_eq!(camera, camera, "a camera of {value} is not a number");
        let eye = camera.eye();
        assert!(eye.y > 0.0 && eye.x.is_finite() && eye.z.is_finite(), "{value} puts the eye at {eye:?}");
        let mut renderer = renderer::<f32>(&scene, &camera);
        assert!(renderer.draw_light(&lights).unwrap());
        assert!(renderer.encode().chunks_exact(4).all(|pixel| pixel[3] == 255));
        let mut renderer = self::renderer::<Fx16>(&scene, &camera);
        assert!(renderer.draw_light(&lights).unwrap());
    }
}

/// Lights each pixel with the kernel, without the renderer, and checks that the light is
/// bit-identical.
fn blocks_left_out_are_dark<S: Format>(camera: &Camera, lights: &[SpotLight]) {
    let scene = stage::scene().unwrap();
    let mut renderer = renderer::<S>(&scene, camera);
    renderer.draw_light(lights).unwrap();
    let compiled: Vec<_> = lights.iter().map(|spot| spot.compile::<S>().unwrap()).collect();
    for y in 0..renderer.height {
        for x in 0..renderer.width {
            let (point, normal, material) = fragment(&renderer, x, y);
            let mut sum = scene.ambient().map(|channel| S::ONE.light(S::gain(channel)));
            for light in &compiled {
                let arrived = light.irradiance_unskipped(point, normal);
                let color = light.color();
                sum.red = S::add_light(sum.red, S::filter(arrived, color.red));
                sum.green = S::add_light(sum.green, S::filter(arrived, color.green));
                sum.blue = S::add_light(sum.blue, S::filter(arrived, color.blue));
            }
            let (light, albedo) =
                (sum.map(S::light_to_f32), renderer.finishes[material as usize].material().albedo());
            let expected =
                Rgb::new(light.red * albedo.red, light.green * albedo.green, light.blue * albedo.blue);
            assert_eq!(renderer.linear(x, y), Some(expected), "{} at {x}, {y}", S::NAME);
        }
    }
}

#[test]
fn a_block_is_left_out_only_where_no_light_arrives() {
    let mut camera = stage::camera();
    let mut lights = stage::lights().unwrap().to_vec();
    for (falloff, outer) in [
        (SoftOrHard::Soft, 180.0),
        (SoftOrHard::Hard, 180.0),
        (SoftOrHard::Hard, 8.0),
        (SoftOrHard::Soft, 5.0),
    ] {
        let cone = Cone::from_outer(falloff, Angle::degrees(outer)).unwrap();
        let axis = Vec3::new(outer - 6.0, -20.0, 3.0);
        lights.push(SpotLight::new(Vec3::new(0.0, 3.0, 0.0), axis, cone).unwrap());
    }
    for _ in 0..5 {
        blocks_left_out_are_dark::<f32>(&camera, &lights);
        blocks_left_out_are_dark::<Fx32>(&camera, &lights);
        blocks_left_out_are_dark::<Fx16>(&camera, &lights);
        camera.orbit(0.5, 0.15);
        camera.zoom(0.75);
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
