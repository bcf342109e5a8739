//! Tests that compare shadow maps with ray casting in f64.

mod ray;

use super::*;
use crate::{Camera, Format, Material, Mesh, Outline, Renderer, scenes::stage};
use core::f32::consts::{PI, TAU};
use fastrand::Rng;
use glam::DVec3;
use luminaire::{
    Angle, Cone, Fx16, Fx32, Rgb, SpotLight, Vec3, falloff::SoftOrHard, light::CompiledSpotLight,
};
use ray::Light;

extern crate std;
use std::string::ToString;

/// Largest error of a shadow edge, in texels.
const TEXELS: f64 = 2.0;

/// A format whose lengths convert exactly to f64.
trait Exact: Format {
    fn exact(length: Self::Length) -> f64;
}

impl Exact for f32 {
    fn exact(length: f32) -> f64 {
        length.into()
    }
}

impl Exact for Fx32 {
    fn exact(length: Self::Length) -> f64 {
        length.to_f64()
    }
}

impl Exact for Fx16 {
    fn exact(length: Self::Length) -> f64 {
        length.to_f64()
    }
}

fn spot(position: Vec3<f32>, target: Vec3<f32>, outer: f32) -> SpotLight<SoftOrHard> {
    let cone = Cone::from_outer(SoftOrHard::Soft, Angle::degrees(outer)).unwrap();
    SpotLight::new(position, target.zip(position, |t, p| t - p), cone).unwrap().with_intensity(50.0).unwrap()
}

fn scene(meshes: impl IntoIterator<Item = Mesh>) -> Scene {
    let mut scene = Scene::new();
    let white = Material::srgb(255, 255, 255);
    meshes.into_iter().for_each(|mesh| scene.add(mesh, white).unwrap());
    scene
}

fn sphere(radius: f32, center: Vec3<f32>) -> Mesh {
    ellipsoid([radius; 2], 28, 56).moved(center)
}

/// The ends of the outline are exactly on the axis, so that no triangle is degenerate.
fn ellipsoid([width, height]: [f32; 2], lines: u8, segments: usize) -> Mesh {
    let angles = (1..lines).map(|line| PI * f32::from(line) / f32::from(lines));
    let outline = angles.fold(Outline::start(0.0, -height), |outline, angle| {
        outline.line_to(width * angle.sin(), -height * angle.cos())
    });
    Mesh::lathe(&outline.line_to(0.0, height), segments)
}

fn floor(half: f32) -> Mesh {
    let floor = Outline::start(half, 0.0).line_to(-half, 0.0);
    Mesh::extrude(&floor, 2.0 * half, 1).moved(Vec3::new(0.0, 0.0, -half))
}

fn drawn<S: Scalar>(scene: &Scene, projection: &Projection, side: usize) -> ShadowMap<S> {
    let mut map = ShadowMap::new(side).unwrap();
    assert!(map.draw(scene, projection).unwrap());
    map
}

/// Compares the shadow map with a ray at every surface point that a camera sees.
///
/// Only points within the cone that face the light are compared. Each point must be lit or in
/// shadow as the ray says, except within [`TEXELS`] of a shadow edge. Returns the number of points
/// that are lit in both, dark in both, and different.
fn assert_is_that_of_rays<S: Exact>(
    scene: &Scene,
    camera: &Camera,
    spot: &SpotLight<SoftOrHard>,
    roll: f32,
    side: usize,
) -> [usize; 3] {
    const SIZE: (usize, usize) = (160, 90);
    let projection = Projection::of(spot).unwrap().turned(Angle::degrees(roll)).unwrap();
    let map = drawn::<S>(scene, &projection, side);
    let (shadow, light) = (map.shadow().unwrap(), Light::new(scene, &projection));
    let compiled: CompiledSpotLight<S, SoftOrHard> = spot.compile().unwrap();
    let mut renderer = Renderer::<S>::new(SIZE.0, SIZE.1).unwrap();
    renderer.draw_geometry(scene, camera);
    let pixels = (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (x, y)));
    let surfaces = pixels.filter_map(|(x, y)| renderer.surface(x, y));
    let dark = S::Irradiance::default();
    let mut counts = [0; 3];
    for (point, _, _) in surfaces.filter(|(point, normal, _)| compiled.irradiance(*point, *normal) > dark) {
        let visibility = shadow.visibility(point);
        let Vec3 { x, y, z } = point.map(S::exact);
        let place = light.place(DVec3::new(x, y, z));
        let sees = light.sees(place);
        assert!((0.0..=1.0).contains(&visibility.to_f32()));
        if visibility == if sees { S::ONE } else { S::ZERO } {
            counts[usize::from(!sees)] += 1;
        } else {
            counts[2] += 1;
            let is_clear = light.is_clear(place, TEXELS, side);
            assert!(!is_clear, "{} at {point:?}, {place:?}: {visibility:?}, seen: {sees}", S::NAME);
        }
    }
    counts
}

fn cameras() -> impl Iterator<Item = Camera> {
    [(0.0, 0.0), (0.9, 0.5), (-2.4, 0.3)].into_iter().map(|(yaw, pitch)| {
        let mut camera = stage::camera();
        camera.orbit(yaw, pitch);
        camera
    })
}

fn assert_stage_is_that_of_rays<S: Exact>() {
    let mut counts = [0; 3];
    for (camera, roll) in cameras().zip([0.0, 30.0, -90.0]) {
        for spot in stage::lights().unwrap() {
            let found = assert_is_that_of_rays::<S>(&stage::scene().unwrap(), &camera, &spot, roll, 512);
            counts = [0, 1, 2].map(|i| counts[i] + found[i]);
        }
    }
    let [lit, hidden, between] = counts;
    assert!(lit > 25_000 && hidden > 5_000, "{lit} lit, {hidden} in shadow");
    assert!((200..1_500).contains(&between), "{between} at an edge");
}

#[test]
fn shadows_on_the_stage_are_those_of_rays_in_f32() {
    assert_stage_is_that_of_rays::<f32>();
}

#[test]
fn shadows_on_the_stage_are_those_of_rays_in_fx32() {
    assert_stage_is_that_of_rays::<Fx32>();
}

#[test]
fn shadows_on_the_stage_are_those_of_rays_in_fx16() {
    assert_stage_is_that_of_rays::<Fx16>();
}

#[test]
fn wide_and_narrow_cones_have_the_shadows_of_rays() {
    let things = || {
        [
            floor(6.0),
            sphere(0.3, Vec3::new(0.7, 0.3, 0.4)),
            Mesh::cuboid(0.4, 0.5, 0.4).moved(Vec3::new(-0.9, 0.0, -0.6)),
        ]
    };
    let camera = Camera::new(Vec3::new(0.0, 0.0, 0.0), 7.0, 0.3, 0.6, 0.6);
    let wide = spot(Vec3::new(0.1, 1.6, 0.0), Vec3::new(0.0, 0.0, 0.0), 150.0);
    let near = Camera::new(Vec3::new(1.2, 0.15, 0.3), 1.0, 0.6, 0.7, 0.6);
    let narrow = spot(Vec3::new(-3.0, 4.0, 2.0), Vec3::new(0.912, 0.512, 0.4), 2.0);
    for (camera, spot) in [(camera, wide), (near, narrow)] {
        for [lit, hidden, _] in [
            assert_is_that_of_rays::<f32>(&scene(things()), &camera, &spot, 10.0, 1024),
            assert_is_that_of_rays::<Fx32>(&scene(things()), &camera, &spot, 10.0, 1024),
            assert_is_that_of_rays::<Fx16>(&scene(things()), &camera, &spot, 10.0, 1024),
        ] {
            assert!(lit > 100 && hidden > 100, "{lit} lit, {hidden} in shadow");
        }
    }
}

/// Returns a random light 1 to 10 metres from the origin that shines on the origin, the side of a
/// map, and the width of a texel at the origin in metres.
fn random_map(rng: &mut Rng) -> (Projection, usize, f32) {
    let (way, aim) = (glam::Vec3::from(random_vector(rng)).normalize(), random_vector(rng));
    let (distance, half) = (10.0_f32.powf(rng.f32()), Angle::degrees(1.5 * 45.0_f32.powf(rng.f32())));
    let wide = distance * half.to_radians().tan();
    let spot = spot((distance * way).into(), aim.map(|c| wide * c), 2.0 * half.to_degrees());
    let projection = Projection::of(&spot).unwrap().turned(Angle::degrees(360.0 * rng.f32())).unwrap();
    let side = (16.0 * 64.1_f32.powf(rng.f32())) as usize;
    (projection, side, 2.0 * wide / side as f32)
}

fn random_vector(rng: &mut Rng) -> Vec3<f32> {
    Vec3::new(rng.f32() - 0.5, rng.f32() - 0.5, rng.f32() - 0.5)
}

/// Returns a random cuboid, frustum or ellipsoid of revolution, whose sides are up to `size`.
fn random_body(rng: &mut Rng, size: f32) -> Mesh {
    let [a, b, c] = [(); 3].map(|()| size * (0.1 + 0.9 * rng.f32()));
    let segments = rng.usize(3..40);
    match rng.u8(..3) {
        0 => Mesh::cuboid(a, b, c),
        1 => ellipsoid([a / 2.0, b / 2.0], rng.u8(2..16), segments),
        _ => {
            let top = rng.f32() * c / 2.0;
            let outline = Outline::start(0.0, 0.0).line_to(a / 2.0, 0.0).line_to(top, b).line_to(0.0, b);
            Mesh::lathe(&outline, segments)
        }
    }
}

/// Returns the number of random cases of a test.
fn cases() -> usize {
    if std::env::var_os("LUMINAIRE_FULL").is_some() { 3_000 } else { 80 }
}

/// Asserts that a convex body is fully lit wherever it is more than `within` texels inside its
/// outline; everywhere, if that is 0. Returns the number of points tested: six of every triangle
/// that faces the light.
fn assert_is_lit<S: Exact>(mesh: Mesh, projection: &Projection, side: usize, within: f64) -> usize {
    let scene = scene([mesh]);
    let map = drawn::<S>(&scene, projection, side);
    let (shadow, light) = (map.shadow().unwrap(), Light::new(&scene, projection));
    let mut tested = 0;
    for triangle in ray::triangles(&scene).flatten() {
        for parts in [
            [0.98, 0.01, 0.01],
            [0.01, 0.98, 0.01],
            [0.01, 0.01, 0.98],
            [0.4, 0.3, 0.3],
            [0.5, 0.01, 0.49],
            [0.49, 0.5, 0.01],
        ] {
            let point: DVec3 = triangle.iter().zip(parts).map(|(&corner, part)| part * corner).sum();
            let place = light.place(point);
            if light.slope(triangle).0 > 0.0 && light.has(place) {
                tested += 1;
                let point = Vec3::from(point.as_vec3()).map(S::length);
                let is_lit = shadow.visibility(point) == S::ONE;
                let is_outer = || within > 0.0 && light.around(place, within, side).contains(&None);
                assert!(is_lit || is_outer(), "{} {side}: {place:?} of {projection:?}", S::NAME);
            }
        }
    }
    tested
}

fn assert_no_surface_shadows_itself<S: Exact>() {
    for side in [64, 512] {
        for elevation in [0.02_f32, 0.3, 1.0, 1.5] {
            let (sine, cosine) = elevation.sin_cos();
            let light = spot(Vec3::new(4.0 * cosine, 4.0 * sine, 1.0), Vec3::new(0.0, 0.1, 0.0), 40.0);
            let flat = Mesh::extrude(&Outline::start(2.5, 0.0).line_to(-2.5, 0.0), 5.0, 40);
            let flat = flat.moved(Vec3::new(0.0, 0.0, -2.5));
            let tested = assert_is_lit::<S>(flat, &Projection::of(&light).unwrap(), side, 0.0);
            assert!(tested > 10, "{tested} points face the light");
        }
    }
    let (mut rng, mut tested) = (Rng::with_seed(7), 0);
    for _ in 0..cases() {
        let (light, side, texel) = random_map(&mut rng);
        let size = texel * (side as f32).powf(rng.f32());
        for (mesh, within) in [(random_body(&mut rng, size), 1.01), (floor(size), 0.0)] {
            let mesh = mesh.turned(random_vector(&mut rng), TAU * rng.f32());
            tested += assert_is_lit::<S>(mesh, &light, side, within);
        }
    }
    assert!(tested > 100 * cases(), "{tested} points face the light");
}

#[test]
fn no_surface_shadows_itself_in_f32() {
    assert_no_surface_shadows_itself::<f32>();
}

#[test]
fn no_surface_shadows_itself_in_fx32() {
    assert_no_surface_shadows_itself::<Fx32>();
}

#[test]
fn no_surface_shadows_itself_in_fx16() {
    assert_no_surface_shadows_itself::<Fx16>();
}

#[test]
fn what_is_right_at_the_light_hides_all_but_its_own_housing() {
    let light = spot(Vec3::new(0.0, 2.0, 0.0), Vec3::new(0.0, 0.0, 0.0), 60.0);
    let projection = Projection::of(&light).unwrap();
    for (distance, expected) in [(0.08, 0.0), (0.03, 1.0)] {
        let lid = Mesh::cuboid(0.5, 0.01, 0.5).moved(Vec3::new(0.0, 2.0 - distance - 0.01, 0.0));
        let map = drawn::<f32>(&scene([floor(4.0), lid]), &projection, 64);
        let shadow = map.shadow().unwrap();
        for point in [Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.9, 0.0, -0.9), Vec3::new(-0.4, 0.0, 1.0)] {
            assert_eq!(shadow.visibility(point), expected, "at {point:?} under a lid at {distance}");
        }
    }
}

#[test]
fn a_solid_around_the_light_hides_everything_outside() {
    let light = spot(Vec3::new(0.0, 2.0, 0.0), Vec3::new(0.0, 0.0, 0.0), 60.0);
    let projection = Projection::of(&light).unwrap();
    let housing = sphere(0.3, Vec3::new(0.0, 2.0, 0.0));
    assert!(housing.is_closed());
    let map = drawn::<f32>(&scene([floor(4.0), housing]), &projection, 64);
    for point in [Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.9, 0.0, -0.9)] {
        assert_eq!(map.shadow().unwrap().visibility(point), 0.0, "at {point:?}");
    }
}

#[test]
fn a_sheet_hides_whichever_side_it_shows() {
    let light = spot(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, 0.0, 0.0), 40.0);
    let projection = Projection::of(&light).unwrap();
    for turn in [0.0, PI] {
        let sheet = floor(0.5).turned(Vec3::new(1.0, 0.0, 0.0), turn).moved(Vec3::new(0.0, 2.0, 0.0));
        let map = drawn::<Fx16>(&scene([sheet]), &projection, 128);
        let at = |x, y| map.shadow().unwrap().visibility(Vec3::new(x, y, 0.0).map(Fx16::length));
        assert_eq!(
            [at(0.0, 0.0), at(0.9, 0.0), at(1.1, 0.0), at(0.0, 2.2)].map(Scalar::to_f32),
            [0.0, 0.0, 1.0, 1.0]
        );
    }
}

/// Tests random sheets and boards. Three texels within their edges, the shadow begins within the
/// distance that the documentation of [`ShadowMap`] states or, if the board is thicker, right
/// behind the board. Some shadows begin beyond nine tenths of the distance.
fn assert_shadows_begin_as_stated<S: Exact>() {
    let (mut rng, [mut tested, mut late]) = (Rng::with_seed(3), [0; 2]);
    for _ in 0..cases() {
        let (projection, side, texel) = random_map(&mut rng);
        let half = texel * side as f32 * (0.05 + 0.5 * rng.f32());
        let thickness = if rng.bool() { half * rng.f32().powi(3) } else { 0.0 };
        let mesh =
            if thickness > 0.0 { Mesh::cuboid(2.0 * half, thickness, 2.0 * half) } else { floor(half) };
        let scene = scene([mesh.turned(random_vector(&mut rng), TAU * rng.f32())]);
        let map = drawn::<S>(&scene, &projection, side);
        let (shadow, light) = (map.shadow().unwrap(), Light::new(&scene, &projection));
        let tangent = projection.tangent();
        let texels = 3.01 + 2.0 * side as f64 * f64::from(slope::place_error::<S>(tangent));
        for triangle in ray::triangles(&scene).flatten() {
            let (height, across) = light.slope(triangle);
            let nearest = triangle.iter().map(|&corner| light.place(corner).depth).fold(9e9, f64::min);
            for _ in 0..8 {
                let parts = [(); 3].map(|()| rng.f64());
                let sum: DVec3 = triangle.iter().zip(parts).map(|(&corner, part)| part * corner).sum();
                let point = sum / parts.iter().sum::<f64>();
                let place = light.place(point);
                let width = 2.0 * f64::from(tangent) / side as f64 * place.depth;
                let bias = texels * across * width / height;
                let is_on = |hit: DVec3| light.is_on(triangle, hit);
                if height <= 0.0
                    || place.depth > 4.0 * nearest.max(0.05)
                    || bias > 0.5
                    || !light.around(place, 3.01, side).into_iter().all(|hit| hit.is_some_and(is_on))
                {
                    continue;
                }
                // A millimetre for the error of points, twice that at this bias.
                let rounding = 2e-3 / height + 2.0 * f64::from(depth_error::<S>(tangent));
                let visibility = |part: f64, least: f32| {
                    let behind = (part * bias / (1.0 - bias)).max(f64::from(least) / height) + rounding;
                    let point = light.beyond(point, 1.0 + behind).as_vec3();
                    shadow.visibility(Vec3::from(point).map(S::length))
                };
                let found = visibility(1.0, 1.001 * thickness);
                assert_eq!(found, S::ZERO, "{} {side} {thickness}: {place:?} of {projection:?}", S::NAME);
                tested += 1;
                late += usize::from(visibility(0.9, 0.0) > S::ZERO);
            }
        }
    }
    assert!(tested > 5 * cases() && late > tested / 100, "{late} of {tested} points are late");
}

#[test]
fn shadows_of_sheets_and_boards_begin_as_stated() {
    assert_shadows_begin_as_stated::<f32>();
    assert_shadows_begin_as_stated::<Fx32>();
    assert_shadows_begin_as_stated::<Fx16>();
}

#[test]
fn objects_outside_of_the_cone_change_no_bit() {
    for spot in stage::lights().unwrap() {
        let spot = spot.with_cone(Cone::from_outer(SoftOrHard::Soft, Angle::degrees(14.0)).unwrap());
        let projection = Projection::of(&spot).unwrap();
        let apart = stage::scene().unwrap();
        let view = View::of_light(&projection, 256);
        let meshes = || apart.objects().iter().map(|object| object.mesh.clone());
        let is_missed = |mesh: &Mesh| view.misses(&Bounds::of(mesh.vertices().iter().map(|v| v.position)));
        assert!(meshes().filter(is_missed).count() > 1, "objects are left out");
        // The other meshes are merged with the floor, so that no mesh is skipped.
        let is_drawn_alone = |mesh: &Mesh| mesh.is_closed() && !is_missed(mesh);
        let rest = meshes().filter(|mesh| !is_drawn_alone(mesh)).fold(Mesh::default(), Mesh::and);
        assert!(!is_missed(&rest));
        let together = scene(meshes().filter(is_drawn_alone).chain([rest]));
        let [apart, together] = [&apart, &together].map(|scene| drawn::<f32>(scene, &projection, 256).depths);
        assert!(apart == together);
    }
}

#[test]
fn a_map_is_drawn_again_only_if_scene_or_light_have_changed() {
    let [key, fill, _] = stage::lights().unwrap().map(|spot| Projection::of(&spot).unwrap());
    let mut map = ShadowMap::<Fx32>::new(64).unwrap();
    assert!(map.shadow().is_none());
    let mut scene = stage::scene().unwrap();
    assert_eq!(map.draw(&scene, &key), Ok(true));
    assert_eq!(map.draw(&scene, &key), Ok(false));
    assert_eq!(map.draw(&scene, &fill), Ok(true));
    scene.add(sphere(0.5, Vec3::new(0.0, 2.0, 2.0)), Material::default()).unwrap();
    assert_eq!(map.draw(&scene, &fill), Ok(true));
    assert_eq!(
        map.depths,
        drawn::<Fx32>(&scene, &fill, 64).depths,
        "nothing is left of what was drawn before"
    );
    scene.set_ambient(Rgb::new(1.0, 1.0, 1.0)).unwrap();
    assert_eq!(map.draw(&scene, &fill), Ok(false));
}

#[test]
fn sides_that_are_too_small_or_too_large_are_refused() {
    for side in [0, 15, 2049] {
        assert_eq!(ShadowMap::<f32>::new(side).unwrap_err(), SizeError::ShadowSide(side));
    }
    assert_eq!(ShadowMap::<f32>::new(16).unwrap().side(), 16);
    assert_eq!(SizeError::ShadowSide(8).to_string(), "side of a shadow map = 8: expected 16 to 2048 texels");
}
