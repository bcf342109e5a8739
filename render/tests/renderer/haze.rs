//! The air before a surface shows only beams that are before it.

use luminaire::{Angle, Cone, Fx16, Rgb, SpotLight, Vec3, dynamic::AnyLight, falloff::Soft, haze::Haze};
use luminaire_render::{Camera, Material, Mesh, Renderer, Scene};

const SIZE: usize = 64;

/// A black box close to the eye hides a light that points away from both, slightly off the line of
/// sight. The visible air ends 4 m behind the light.
#[test]
fn a_light_that_points_away_behind_a_surface_is_dark() {
    let middle = Vec3::new(0.0, 2.0, 0.0);
    let mut scene = Scene::new();
    scene
        .add(Mesh::cuboid(0.2, 0.2, 0.2).moved(Vec3::new(0.0, 1.9, 0.0)), Material::srgb(0, 0, 0))
        .expect("a sound mesh");
    scene.set_haze(Some(Haze::new(0.02).unwrap()));
    let cone = Cone::from_outer(Soft, Angle::degrees(40.0)).unwrap();
    for setting in 0..90 {
        let number = setting as f32;
        let camera = Camera::new(middle, 0.35, 0.2 + 0.01 * number, 0.3, 0.2);
        let (mut planned, mut everything) = (renderer(&scene, &camera), renderer(&scene, &camera));
        let eye = camera.eye();
        let ahead = middle.zip(eye, |m, e| (m - e) / 0.35);
        let off = 0.009 + 0.017 * number / 90.0;
        let position = eye.zip(ahead, |e, a| e + 4.5 * a);
        let position = Vec3::new(position.x, position.y + off, position.z);
        let spot = SpotLight::new(position, ahead, cone).unwrap();
        let lights = [AnyLight::from(spot.with_intensity(16.0).unwrap())];
        planned.draw_light(&lights).unwrap();
        everything.draw_everything(&lights).unwrap();
        for (x, y) in (0..SIZE * SIZE).map(|i| (i % SIZE, i / SIZE)) {
            assert!(everything.surface(x, y).is_some(), "the box fills the picture");
            let seen = [&planned, &everything].map(|renderer| renderer.linear(x, y).unwrap());
            assert_eq!(seen, [Rgb::default(); 2], "{spot:?} at {x} {y}");
        }
    }
}

fn renderer(scene: &Scene, camera: &Camera) -> Renderer<Fx16> {
    let mut renderer = Renderer::new(SIZE, SIZE).unwrap();
    assert!(renderer.draw_geometry(scene, camera));
    renderer
}
