//! Each pass is repeated only if its input has changed, and a refusal leaves the picture as it was.

use luminaire::{Angle, Cone, Fx16, SpotLight, Vec3, falloff::SoftOrHard};
use luminaire_render::{Renderer, scenes::stage};

fn lit() -> Renderer<Fx16> {
    let mut renderer = Renderer::new(96, 54).unwrap();
    assert!(renderer.draw_geometry(&stage::scene().unwrap(), &stage::camera()));
    assert!(renderer.draw_light(&stage::lights().unwrap()).unwrap());
    renderer.encode();
    renderer
}

#[test]
fn a_light_may_go_while_the_camera_moves() {
    let mut renderer = lit();
    let lights = stage::lights().unwrap();
    let mut camera = stage::camera();
    camera.orbit(0.1, 0.0);
    assert!(renderer.draw_geometry(&stage::scene().unwrap(), &camera));
    assert!(renderer.draw_light(&lights[..2]).unwrap());
    let mut fresh = Renderer::<Fx16>::new(96, 54).unwrap();
    fresh.draw_geometry(&stage::scene().unwrap(), &camera);
    fresh.draw_light(&lights[..2]).unwrap();
    assert_eq!(renderer.encode(), fresh.encode());
}

#[test]
fn a_refused_light_leaves_the_picture() {
    let mut renderer = lit();
    let (scene, lights) = (stage::scene().unwrap(), stage::lights().unwrap());
    let before = (renderer.pixels().to_vec(), renderer.linear(40, 30));
    let needle = Cone::from_outer(SoftOrHard::Hard, Angle::degrees(0.5)).unwrap();
    let needle = SpotLight::new(Vec3::new(0.0, 3.0, 0.0), Vec3::new(0.0, -1.0, 0.0), needle).unwrap();
    let refused = renderer.draw_light(&[needle]).unwrap_err();
    assert!(refused.to_string().starts_with("outer angle = 0.5: expected"), "{refused}");
    assert_eq!((renderer.encode().to_vec(), renderer.linear(40, 30)), before);
    assert!(!renderer.draw_light(&lights).unwrap(), "the lights are still those of the picture");
    // With another geometry, too.
    let mut camera = stage::camera();
    camera.orbit(1.0, 0.0);
    assert!(renderer.draw_geometry(&scene, &camera));
    assert!(renderer.draw_light(&[needle]).is_err());
    assert_eq!(renderer.encode(), before.0);
    assert!(renderer.draw_light(&lights).unwrap());
    assert_ne!(renderer.encode(), before.0);
}

#[test]
fn sizes_that_can_be_are_drawn() {
    for (width, height) in [(1, 1), (1, 8192), (8192, 1), (31, 7), (33, 5)] {
        let mut renderer = Renderer::<f32>::new(width, height).unwrap();
        assert_eq!(renderer.pixels().len(), width * height * 4);
        assert!(renderer.pixels().chunks_exact(4).all(|pixel| pixel == [0, 0, 0, 255]), "black until drawn");
        assert!(renderer.draw_geometry(&stage::scene().unwrap(), &stage::camera()));
        assert!(renderer.draw_light(&stage::lights().unwrap()).unwrap());
        assert_eq!(renderer.encode().len(), width * height * 4);
        assert!(renderer.linear(width - 1, height - 1).is_some());
        assert_eq!((renderer.linear(width, 0), renderer.linear(0, height)), (None, None));
    }
}
